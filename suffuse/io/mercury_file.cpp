#include "suffuse/io/mercury_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace suffuse::io {
namespace {

constexpr std::size_t head_fields = 8, row_fields = 14; // in three dimensions
using Fields = std::vector<std::string_view>;

/// Numbers behind the first field that is this word.
std::optional<Vec3> vector_behind(const LineReader& reader, const Fields& fields, std::string_view word) {
    const auto at = std::ranges::find(fields, word);
    if (fields.end() - at < 4) {
        return std::nullopt;
    }
    return Vec3{to_number(reader, at[1], word), to_number(reader, at[2], word), to_number(reader, at[3], word)};
}

std::optional<double> number_behind(const LineReader& reader, const Fields& fields, std::string_view word) {
    const auto at = std::ranges::find(fields, word);
    return fields.end() - at < 2 ? std::nullopt : std::optional(to_number(reader, at[1], word));
}

void add_grain(
    const LineReader& reader, grains::Grains& grains, const Vec3& x, const Vec3& v, const Vec3& w, double r,
    double density
) {
    if (!(r > 0)) {
        reader.complain(fmt::format("found radius {}, expected a positive one", r));
    }
    const auto g = grains::add_grain(grains, x, r, density);
    grains.velocity[g] = v;
    grains.spin[g] = w;
}

cell::Cell box_between(const LineReader& reader, const Vec3& low, const Vec3& high) {
    const Vec3 edges = high - low;
    if (!(edges.x > 0 && edges.y > 0 && edges.z > 0)) {
        reader.complain("found a box without a volume, expected its upper corner beyond its lower one");
    }
    return {diagonal(edges), {}};
}

/// Where the three periodic boundaries stand.
struct Periods {
    std::array<std::optional<std::pair<double, double>>, 3> sides;

    void take(const LineReader& reader, const Fields& fields) {
        const auto normal = vector_behind(reader, fields, "normal");
        const auto left = number_behind(reader, fields, "distanceLeft"),
                   right = number_behind(reader, fields, "distanceRight");
        if (!normal || !left || !right) {
            return;
        }
        for (int axis = 0; axis < 3; ++axis) {
            if (std::abs(std::abs((*normal)[axis]) - norm(*normal)) <= 1e-9 * norm(*normal)) {
                sides[static_cast<std::size_t>(axis)] = {std::min(*left, *right), std::max(*left, *right)};
            }
        }
    }
};

} // namespace

bool looks_like_mercury_data(std::string_view text) {
    LineReader reader("", text.substr(0, 4096));
    if (!reader.next()) {
        return false;
    }
    const Fields head = split_at_blanks(reader.line());
    if (head.size() != head_fields || !number_of<std::size_t>(head[0]) ||
        !std::ranges::all_of(head, [](std::string_view field) { return number_of<double>(field).has_value(); })) {
        return false;
    }
    return reader.next() && split_at_blanks(reader.line()).size() == row_fields;
}

ImportedPacking parse_mercury_data(const std::string& file, std::string_view text, double density) {
    ImportedPacking packing;
    LineReader reader(file, text);
    std::size_t frames = 0;
    while (reader.next()) {
        const Fields head = split_at_blanks(reader.line());
        if (head.size() != head_fields) {
            reader.complain(
                fmt::format("found {} fields, expected {}: number, time and the box", head.size(), head_fields)
            );
        }
        const std::size_t count = to_count(reader, head[0], "number of particles");
        const auto corner = [&](std::size_t k) {
            return Vec3{
                to_number(reader, head[k], "x"), to_number(reader, head[k + 1], "y"),
                to_number(reader, head[k + 2], "z")};
        };
        const Vec3 low = corner(2), high = corner(5);
        packing = {};
        packing.cell = box_between(reader, low, high);
        packing.origin = low;
        for (std::size_t row = 0; row < count; ++row) {
            if (!reader.next()) {
                reader.complain(fmt::format("the file ends, expected {} particles, found {}", count, row));
            }
            const Fields f = split_at_blanks(reader.line());
            if (f.size() != row_fields) {
                reader.complain(fmt::format("found {} fields, expected {}", f.size(), row_fields));
            }
            const auto vector = [&](std::size_t k, std::string_view name) {
                return Vec3{
                    to_number(reader, f[k], name), to_number(reader, f[k + 1], name),
                    to_number(reader, f[k + 2], name)};
            };
            add_grain(
                reader, packing.grains, vector(0, "position") - low, vector(3, "velocity"), vector(10, "spin"),
                to_number(reader, f[6], "radius"), density
            );
        }
        ++frames;
    }
    if (frames > 1) {
        packing.warnings.push_back(fmt::format("{}: the last of {} frames is read", file, frames));
    }
    packing.warnings.push_back(fmt::format(
        "{}: its box is taken as the periodic cell; a .data file does not say which of its sides are walls", file
    ));
    return packing;
}

bool looks_like_mercury_restart(std::string_view text) {
    return text.starts_with("restart_version");
}

ImportedPacking parse_mercury_restart(const std::string& file, std::string_view text, double density) {
    ImportedPacking packing;
    LineReader reader(file, text);
    Periods periods;
    std::size_t expected = 0, interactions = 0, walls = 0;
    while (reader.next()) {
        const Fields f = split_at_blanks(reader.line());
        const std::string_view word = f.front();
        const auto counted = [&] { return f.size() == 2 ? number_of<std::size_t>(f[1]) : std::nullopt; };
        if (word == "Particles" && counted()) {
            expected = *counted();
        } else if (word == "Interactions" && counted()) {
            interactions = *counted();
        } else if (word == "Walls" && counted()) {
            walls = *counted();
        } else if (word == "PeriodicBoundary") {
            periods.take(reader, f);
        } else if (word.ends_with("Particle")) {
            const auto x = vector_behind(reader, f, "position");
            const auto r = number_behind(reader, f, "radius");
            if (!x || !r) {
                reader.complain("a particle without position or radius, expected both words with their numbers");
            }
            add_grain(
                reader, packing.grains, *x, vector_behind(reader, f, "velocity").value_or(Vec3{}),
                vector_behind(reader, f, "angularVelocity").value_or(Vec3{}), *r, density
            );
        }
    }
    if (packing.grains.size() != expected) {
        reader.complain(
            fmt::format("found {} particles, expected {}: the file is not complete", packing.grains.size(), expected)
        );
    }
    if (periods.sides[0] && periods.sides[1] && periods.sides[2]) {
        const auto side = [&periods](std::size_t k) { return *periods.sides[k]; };
        const Vec3 low{side(0).first, side(1).first, side(2).first},
            high{side(0).second, side(1).second, side(2).second};
        packing.cell = box_between(reader, low, high);
        packing.origin = low;
        for (Vec3& x : packing.grains.position) {
            x = x - low;
        }
    } else {
        packing.no_cell = fmt::format("{}: it is not periodic along all axes", file);
    }
    if (interactions > 0) {
        packing.warnings.push_back(fmt::format(
            "{}: {} interactions carry contact memory, which is not read; settle the packing first", file, interactions
        ));
    }
    if (walls > 0) {
        packing.warnings.push_back(fmt::format("{}: {} walls are not read", file, walls));
    }
    return packing;
}

} // namespace suffuse::io
