#include "suffuse/io/overlaps.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/grouped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::io {
namespace {

constexpr double densest = 2;    // volume of grains over that of their cell, beyond which no overlap is meant
constexpr double widest = 1.25;  // grain over the period of its cell: contacts with its own image overlap by less
constexpr int most_images = 100; // of a grain along one direction, in a cell that is sheared

[[noreturn]] void refuse_grains(const std::string& origin, const std::string& message) {
    throw CaseError(origin + ": " + message, origin);
}

/// A position that no image of the cell can name is a mistake of the file; later it would pass for a motion blown up.
void check_positions(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    const Mat3 inverse_h = inverse(h);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3& x = grains.position[g];
        if (!std::isfinite(norm2(x)) || !cell::has_period(inverse_h, x)) {
            refuse_grains(
                origin, fmt::format(
                            "grain {}: found the position ({:.6g}, {:.6g}, {:.6g}) m, more than {} cells away from "
                            "the first; check the row and that lengths are in m",
                            grains.id[g], x.x, x.y, x.z, grouped(cell::largest_period)
                        )
            );
        }
    }
}

} // namespace

// Looked for as pairs, grains that reach beyond their images, or have no room at all, would touch thousands of them.
std::optional<std::string> size_complaint(const grains::Grains& grains, const Mat3& h) {
    if (grains.size() == 0) {
        return std::nullopt;
    }
    const double narrowest = std::min({norm(h.column(0)), norm(h.column(1)), norm(h.column(2))});
    const auto row = static_cast<std::size_t>(std::ranges::max_element(grains.radius) - grains.radius.begin());
    const double radius = grains.radius[row];
    if (!(2 * radius <= widest * narrowest)) { // not so either where they overflow
        return fmt::format(
            "grain {} has a radius of {:.6g} m and does not fit into a cell {:.6g} m wide; lengths are in m: check "
            "that none was given in mm",
            grains.id[row], radius, narrowest
        );
    }
    const Vec3 width = cell::widths(h);
    const double thinnest = std::min({width.x, width.y, width.z});
    if (!(2 * radius <= most_images * thinnest)) {
        return fmt::format(
            "the cell is sheared until two of its faces are {:.3g} m apart, and grains of {:.3g} m would meet their "
            "images more than {} times over; check its tilt",
            thinnest, 2 * radius, most_images
        );
    }
    if (const double share = grains::solid_volume(grains) / std::abs(determinant(h)); !(share <= densest)) {
        return fmt::format(
            "the grains have {:.3g} times the volume of the cell; check its edges, the unit of lengths, and that radii "
            "are not diameters",
            share
        );
    }
    return std::nullopt;
}

std::string names_of(const grains::Grains& grains, const neighbors::Pair& pair) {
    return pair.first == pair.second ? fmt::format("grain {} and its own image", grains.id[pair.first])
                                     : fmt::format("grains {} and {}", grains.id[pair.first], grains.id[pair.second]);
}

std::vector<Overlap> find_overlaps(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    if (const auto complaint = size_complaint(grains, h)) {
        refuse_grains(origin, *complaint);
    }
    check_positions(grains, h, origin);
    std::vector<Overlap> found;
    for (const neighbors::Pair& p : neighbors::find_pairs(h, grains.position, grains.radius, 0.0)) {
        const double ri = grains.radius[p.first], rj = grains.radius[p.second];
        const double distance = norm(grains.position[p.second] + cell::shift(h, p.image) - grains.position[p.first]);
        if (const double share = (ri + rj - distance) / std::min(ri, rj); share > 0) {
            found.push_back({p, share});
        }
    }
    return found;
}

void check_apart(const grains::Grains& grains, const std::vector<Overlap>& overlaps, const std::string& origin) {
    constexpr double same_place = 1e-9; // of the smaller radius
    for (const Overlap& o : overlaps) {
        const double ri = grains.radius[o.pair.first], rj = grains.radius[o.pair.second];
        if (o.share > (ri + rj) / std::min(ri, rj) - same_place) {
            refuse_grains(
                origin, names_of(grains, o.pair) + " are at the same place; check that each grain has one row"
            );
        }
    }
}

} // namespace suffuse::io
