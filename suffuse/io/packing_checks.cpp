#include "suffuse/io/packing_checks.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/io/mean_motion.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::io {
namespace {

constexpr double widest_void_ratio = 20; // of a cloud that is still to be compacted [-]
constexpr double densest = 2;            // volume of grains over that of their cell, beyond which no overlap is meant

constexpr int most_images = 100; // of a grain along one direction, in a cell that is sheared

constexpr double most_overlap = 2; // two like grains in one place [-]

struct Overlaps {
    neighbors::Pair worst;
    double largest = 0, mean = 0; ///< over the smaller radius [-]
    std::size_t contacts = 0;     ///< pairs that overlap
};

[[noreturn]] void refuse(const std::string& origin, const std::string& message) {
    throw CaseError(origin + ": " + message, origin);
}

/// Grains that reach beyond their images, or have no room at all, are a mistake of units; looked for as pairs, each
/// would touch thousands of them.
void check_sizes(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    const double narrowest = std::min({norm(h.column(0)), norm(h.column(1)), norm(h.column(2))});
    const double largest = 2 * *std::max_element(grains.radius.begin(), grains.radius.end());
    if (!(largest <= 2 * narrowest)) { // not so either where they overflow
        refuse(
            origin, fmt::format(
                        "the largest grain has a diameter of {:.6g} m in a cell {:.6g} m wide; lengths in the file are "
                        "in m: check its unit, and that of the cell",
                        largest, narrowest
                    )
        );
    }
    const Vec3 width = cell::widths(h);
    const double thinnest = std::min({width.x, width.y, width.z});
    if (!(largest <= most_images * thinnest)) {
        refuse(
            origin,
            fmt::format(
                "the cell is sheared until two of its faces are {:.3g} m apart, and grains of {:.3g} m would meet "
                "their images more than {} times over; check its tilt",
                thinnest, largest, most_images
            )
        );
    }
    if (const double share = grains::solid_volume(grains) / std::abs(determinant(h)); !(share <= densest)) {
        refuse(
            origin, fmt::format(
                        "the grains have {:.3g} times the volume of the cell; check its edges, the unit of lengths, "
                        "and that radii are not diameters",
                        share
                    )
        );
    }
}

/// A position that no image of the cell can name is a mistake of the file; later it would pass for a motion blown up.
void check_positions(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    const Mat3 inverse_h = inverse(h);
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const Vec3& x = grains.position[g];
        if (!std::isfinite(norm2(x)) || !cell::has_period(inverse_h, x)) {
            refuse(
                origin, fmt::format(
                            "grain {}: found the position ({:.6g}, {:.6g}, {:.6g}) m, more than {} cells away from "
                            "the first; check the row and that lengths are in m",
                            grains.id[g], x.x, x.y, x.z, grouped(cell::largest_period)
                        )
            );
        }
    }
}

std::string names_of(const grains::Grains& grains, const neighbors::Pair& pair) {
    return pair.first == pair.second ? fmt::format("grain {} and its own image", grains.id[pair.first])
                                     : fmt::format("grains {} and {}", grains.id[pair.first], grains.id[pair.second]);
}

/// Two grains in one place have no normal, however much overlap is allowed.
Overlaps find_overlaps(const grains::Grains& grains, const Mat3& h, const std::string& origin) {
    check_sizes(grains, h, origin);
    check_positions(grains, h, origin);
    constexpr double same_place = 1e-9; // of the smaller radius
    Overlaps found;
    double sum = 0;
    for (const neighbors::Pair& p : neighbors::find_pairs(h, grains.position, grains.radius, 0.0)) {
        const double ri = grains.radius[p.first], rj = grains.radius[p.second], smaller = std::min(ri, rj);
        const double distance = norm(grains.position[p.second] + cell::shift(h, p.image) - grains.position[p.first]);
        if (distance < same_place * smaller) {
            refuse(origin, names_of(grains, p) + " are at the same place; check that each grain has one row");
        }
        const double overlap = (ri + rj - distance) / smaller;
        if (!(overlap > 0)) {
            continue;
        }
        ++found.contacts;
        sum += overlap;
        if (overlap > found.largest) {
            found.worst = p;
            found.largest = overlap;
        }
    }
    found.mean = found.contacts > 0 ? sum / static_cast<double>(found.contacts) : 0;
    return found;
}

std::string complaint_about(const Overlaps& found, const grains::Grains& grains, double share) {
    return fmt::format(
        "{} overlap by {:.3g} of the smaller radius ({:.6g} mm), allowed {:.3g}; check that the cell is the packing's "
        "own, that radii are not diameters and that lengths are in m, or allow a larger overlap",
        names_of(grains, found.worst), found.largest,
        std::min(grains.radius[found.worst.first], grains.radius[found.worst.second]) * 1e3, share
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
        const Overlaps found = find_overlaps(read.grains, h, file);
        taken.overlap = found.largest;
        taken.mean_overlap = found.mean;
        taken.contacts = found.contacts;
        if (found.largest > request.max_overlap) {
            const std::string complaint = complaint_about(found, read.grains, request.max_overlap);
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
    const Overlaps found = find_overlaps(grains, cell.h, origin);
    if (found.largest > share) {
        refuse(origin, complaint_about(found, grains, share));
    }
    return found.largest;
}

} // namespace suffuse::io
