#include "suffuse/io/packing_checks.hpp"

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/mean_motion.hpp"
#include "suffuse/io/overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::io {
namespace {

constexpr double widest_void_ratio = 20; // of a cloud that is still to be compacted [-]

constexpr double most_overlap = 2; // two like grains in one place [-]

[[noreturn]] void refuse(const std::string& origin, const std::string& message) {
    throw CaseError(origin + ": " + message, origin);
}

/// The first of the largest; none overlaps where there are none.
Overlap worst_of(const std::vector<Overlap>& overlaps) {
    const auto worst = std::ranges::max_element(overlaps, {}, &Overlap::share);
    return worst == overlaps.end() ? Overlap{} : *worst;
}

double mean_of(const std::vector<Overlap>& overlaps) {
    double sum = 0;
    for (const Overlap& overlap : overlaps) {
        sum += overlap.share;
    }
    return overlaps.empty() ? 0 : sum / static_cast<double>(overlaps.size());
}

std::string complaint_about(const Overlap& worst, const grains::Grains& grains, double share) {
    return fmt::format(
        "{} overlap by {:.3g} of the smaller radius ({:.6g} mm), allowed {:.3g}; check that the cell is the packing's "
        "own, that radii are not diameters and that lengths are in m, or allow a larger overlap",
        names_of(grains, worst.pair), worst.share,
        std::min(grains.radius[worst.pair.first], grains.radius[worst.pair.second]) * 1e3, share
    );
}

/// What to say of grains of a size that no soil has, which is what a file in mm looks like.
std::optional<std::string> size_warning(const grains::Grains& grains) {
    constexpr double coarsest = 63e-3, finest = 1e-7; // gravel ends, and clay is colloidal, there [m]
    std::vector<double> radius = grains.radius;
    const auto middle = radius.begin() + std::ssize(radius) / 2;
    std::nth_element(radius.begin(), middle, radius.end());
    const double median = 2 * *middle;
    if (median >= finest && median <= coarsest) {
        return std::nullopt;
    }
    return fmt::format(
        "the median diameter is {:.4g} m, {}; lengths are read in m: for a file in mm use unit = \"1 mm\" in a case or "
        "in Python, or --unit mm of suffuse import",
        median, median > coarsest ? "coarser than gravel" : "finer than clay"
    );
}

/// What to say of a cell so narrow that results depend on it.
std::optional<std::string> narrow_cell_warning(const grains::Grains& grains, const Mat3& h) {
    const Vec3 width = cell::widths(h);
    const double ratio =
        std::min({width.x, width.y, width.z}) / (2 * *std::max_element(grains.radius.begin(), grains.radius.end()));
    if (ratio >= grains::narrow_cell) {
        return std::nullopt;
    }
    return fmt::format(
        "the cell is {:.1f} times as wide as the largest grain; below {:.0f} times results depend on the sample", ratio,
        grains::narrow_cell
    );
}

/// What to say of grains that are lost in their cell.
std::optional<std::string> empty_cell_warning(const grains::Grains& grains, const Mat3& h) {
    const double solid = grains::solid_volume(grains), void_ratio = std::abs(determinant(h)) / solid - 1;
    if (void_ratio <= widest_void_ratio) {
        return std::nullopt;
    }
    return fmt::format(
        "the grains fill a share of {:.1e} of the cell (void ratio {:.3g}): check the cell and the unit of lengths",
        1 / (1 + void_ratio), void_ratio
    );
}

std::string cell_text(const Mat3& h) {
    const bool is_box = h == diagonal({h(0, 0), h(1, 1), h(2, 2)});
    return fmt::format("{:.6g} x {:.6g} x {:.6g} m{}", h(0, 0), h(1, 1), h(2, 2), is_box ? "" : ", sheared");
}

/// What to say of a cell that is taken in place of the file's own.
std::optional<std::string> other_cell_warning(const ImportedPacking& read, const Mat3& h) {
    constexpr double rounding = 1e-9; // of a cell that was copied
    if (!read.cell) {
        return std::nullopt;
    }
    const Mat3& own = read.cell->h;
    double difference = 0;
    for (int k = 0; k < 3; ++k) {
        difference = std::max(difference, norm(h.column(k) - own.column(k)) / norm(own.column(k)));
    }
    if (difference <= rounding) {
        return std::nullopt;
    }
    return fmt::format("the cell given, {}, is taken, not the file's own, {}", cell_text(h), cell_text(own));
}

/// What to say of a mean motion that was found in the velocities.
std::string gradient_warning(const Mat3& g) {
    return fmt::format(
        "the grains move as a cell with the velocity gradient [[{:.4g}, {:.4g}, {:.4g}], [{:.4g}, {:.4g}, {:.4g}], "
        "[{:.4g}, {:.4g}, {:.4g}]] 1/s does, which is taken for the cell's; velocity_gradient says another one",
        g(0, 0), g(0, 1), g(0, 2), g(1, 0), g(1, 1), g(1, 2), g(2, 0), g(2, 1), g(2, 2)
    );
}

/// The box is the cell from then on, whatever the file says of its own.
CutGrains cut_out(ImportedPacking& read, const PackingRequest& request) {
    if (request.cell) {
        throw CaseError("a box and a cell were given: the box that is cut out is the cell, so leave the cell out");
    }
    for (Vec3& x : read.grains.position) {
        x = x + read.origin;
    }
    const CutGrains left_out = cut_box(read.grains, *request.box, request.max_overlap, request.file.string());
    read.cell = cell::Cell{diagonal(request.box->high - request.box->low), {}};
    read.no_cell.clear();
    return left_out;
}

std::string cut_warning(const CutGrains& left_out) {
    return fmt::format(
        "left out: {} with the center outside of the box, {} that overlap across its faces; relax the packing, whose "
        "faces are cut",
        plural(static_cast<std::int64_t>(left_out.outside), "grain"),
        count_text(static_cast<std::int64_t>(left_out.across))
    );
}

} // namespace

TakenPacking take_packing(const PackingRequest& request) {
    const std::string file = request.file.string(), where = request.where.empty() ? file : request.where;
    if (!(request.max_overlap > 0 && request.max_overlap <= most_overlap)) {
        throw CaseError(fmt::format(
            "found a max_overlap of {:.6g}, expected a share of the smaller radius above 0, at most {}",
            request.max_overlap, most_overlap
        ));
    }
    ImportedPacking read = read_packing(request.file, request.density, request.unit, request.radius);
    TakenPacking taken;
    taken.warnings = std::move(read.warnings);
    const auto say = [&](const std::optional<std::string>& warning) {
        if (warning) {
            taken.warnings.push_back(where + ": " + *warning);
        }
    };
    if (request.box) {
        taken.left_out = cut_out(read, request);
        taken.warnings.push_back(where + ": " + cut_warning(*taken.left_out));
    }
    say(size_warning(read.grains));
    if (request.velocity_gradient) {
        taken.velocity_gradient = *request.velocity_gradient;
    } else if (const auto found = find_velocity_gradient(read.grains)) {
        taken.velocity_gradient = *found;
        say(gradient_warning(*found));
    }
    if (request.cell || read.cell) {
        const Mat3& h = taken.h.emplace(request.cell ? *request.cell : read.cell->h);
        if (!read.no_cell.empty()) {
            taken.warnings.push_back(read.no_cell + "; the cell given is, and grains meet across its faces");
        }
        say(other_cell_warning(read, h));
        say(narrow_cell_warning(read.grains, h));
        say(empty_cell_warning(read.grains, h));
        const std::vector<Overlap> found = find_overlaps(read.grains, h, file);
        check_apart(read.grains, found, file);
        const Overlap worst = worst_of(found);
        taken.overlap = worst.share;
        taken.mean_overlap = mean_of(found);
        taken.contacts = found.size();
        if (worst.share > request.max_overlap) {
            const std::string complaint = complaint_about(worst, read.grains, request.max_overlap);
            if (!request.only_looks) {
                refuse(file, complaint);
            }
            say(complaint);
        }
    } else {
        taken.no_cell = read.no_cell.empty() ? file + " carries no cell" : read.no_cell;
    }
    taken.grains = std::move(read.grains);
    return taken;
}

double check_overlaps(const grains::Grains& grains, const cell::Cell& cell, double share, const std::string& origin) {
    const std::vector<Overlap> found = find_overlaps(grains, cell.h, origin);
    check_apart(grains, found, origin);
    const Overlap worst = worst_of(found);
    if (worst.share > share) {
        refuse(origin, complaint_about(worst, grains, share));
    }
    return worst.share;
}

} // namespace suffuse::io
