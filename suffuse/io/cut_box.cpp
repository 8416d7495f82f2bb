#include "suffuse/io/cut_box.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace suffuse::io {
namespace {

using Rows = std::vector<std::uint32_t>;

Rows rows_inside(const grains::Grains& grains, const Box& box) {
    Rows rows;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        const Vec3& x = grains.position[g];
        const bool is_inside = x.x >= box.low.x && x.y >= box.low.y && x.z >= box.low.z && x.x < box.high.x &&
                               x.y < box.high.y && x.z < box.high.z;
        if (is_inside) {
            rows.push_back(g);
        }
    }
    return rows;
}

/// The smaller one; of equal ones the later.
std::uint32_t smaller_of(const grains::Grains& grains, const neighbors::Pair& pair) {
    return grains.radius[pair.first] < grains.radius[pair.second] ? pair.first : pair.second;
}

/// Grains that remain when those of the worst overlaps across a face go first.
Rows rows_apart(const grains::Grains& grains, const Mat3& h, double max_overlap, const std::string& file) {
    std::vector<Overlap> across = find_overlaps(grains, h, file);
    std::erase_if(across, [&](const Overlap& o) { return o.pair.image == cell::Image{} || o.share <= max_overlap; });
    std::ranges::stable_sort(across, std::greater{}, &Overlap::share);
    std::vector<bool> stays(grains.size(), true);
    for (const Overlap& o : across) {
        if (stays[o.pair.first] && stays[o.pair.second]) {
            stays[smaller_of(grains, o.pair)] = false;
        }
    }
    Rows rows;
    for (std::uint32_t g = 0; g < grains.size(); ++g) {
        if (stays[g]) {
            rows.push_back(g);
        }
    }
    return rows;
}

void keep(grains::Grains& grains, const Rows& rows) {
    grains::select_rows(grains, rows);
    std::iota(grains.id.begin(), grains.id.end(), 0U);
}

void need_grains(const grains::Grains& grains, const std::string& file) {
    if (grains.size() == 0) {
        throw CaseError(file + ": no grain is left in the box; check its corners and the unit of lengths", file);
    }
}

} // namespace

void check_box(const Box& box) {
    const Vec3 edges = box.high - box.low;
    const double volume = edges.x * edges.y * edges.z;
    if (!(edges.x > 0 && edges.y > 0 && edges.z > 0 && std::isfinite(volume))) {
        throw CaseError(fmt::format(
            "box: found edges of {:.6g}, {:.6g} and {:.6g} m, expected positive ones: the lower corner, then the upper "
            "corner",
            edges.x, edges.y, edges.z
        ));
    }
}

CutGrains cut_box(grains::Grains& grains, const Box& box, double max_overlap, const std::string& file) {
    check_box(box);
    const std::size_t all = grains.size();
    keep(grains, rows_inside(grains, box));
    need_grains(grains, file);
    for (Vec3& x : grains.position) {
        x = x - box.low;
    }
    const std::size_t inside = grains.size();
    keep(grains, rows_apart(grains, diagonal(box.high - box.low), max_overlap, file));
    need_grains(grains, file);
    return {all - inside, inside - grains.size()};
}

} // namespace suffuse::io
