#include "suffuse/io/xyz_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::io {
namespace {

/// The value of `key=` in the second line, without its quotes; empty where it is not there.
std::string_view value_of(std::string_view line, std::string_view key) {
    for (std::size_t at = line.find(key); at != std::string_view::npos; at = line.find(key, at + 1)) {
        const std::size_t equals = at + key.size();
        const bool is_word = at == 0 || line[at - 1] == ' ';
        if (!is_word || equals >= line.size() || line[equals] != '=') {
            continue;
        }
        std::string_view value = line.substr(equals + 1);
        if (value.starts_with('"')) {
            value.remove_prefix(1);
            return value.substr(0, value.find('"'));
        }
        return value.substr(0, value.find(' '));
    }
    return {};
}

/// First field of each property, and how many there are.
struct Layout {
    std::vector<std::string_view> name; ///< one a field: "pos", "pos", "pos", "radius", ...

    [[nodiscard]] std::optional<std::size_t> find(std::string_view wanted, std::size_t width) const {
        const auto at = std::find(name.begin(), name.end(), wanted);
        const auto count = static_cast<std::size_t>(std::count(name.begin(), name.end(), wanted));
        return count == width ? std::optional<std::size_t>(at - name.begin()) : std::nullopt;
    }
};

Layout read_layout(const LineReader& reader, std::string_view properties) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t colon = properties.find(':');
        parts.push_back(properties.substr(0, colon));
        if (colon == std::string_view::npos) {
            break;
        }
        properties.remove_prefix(colon + 1);
    }
    Layout layout;
    constexpr std::size_t most = 1000;
    for (std::size_t k = 0; k + 2 < parts.size(); k += 3) {
        const std::size_t width = to_count(reader, parts[k + 2], "Properties");
        if (width > most) {
            reader.complain(fmt::format("found a property of {} columns, expected fewer", width));
        }
        layout.name.insert(layout.name.end(), width, parts[k]);
    }
    return layout;
}

VectorColumns three_from(std::size_t first) {
    return {first, first + 1, first + 2};
}

/// Where the radius or the diameter is.
struct SizeColumn {
    std::string_view name;
    double to_radius = 1;
    std::optional<std::size_t> at = {};
};

SizeColumn find_size(const Layout& layout) {
    for (const auto& [name, to_radius] :
         {std::pair{"radius", 1.0}, {"Radius", 1.0}, {"radii", 1.0}, {"diameter", 0.5}}) {
        if (const auto at = layout.find(name, 1)) {
            return {name, to_radius, at};
        }
    }
    return {};
}

void check_layout(const LineReader& reader, const PackingSource& source, bool has_position, const SizeColumn& size) {
    if (!has_position) {
        reader.complain("Properties: expected pos:R:3 among them");
    }
    if (!size.at && !source.radius) {
        reader.complain(
            "Properties: expected radius:R:1 or diameter:R:1 among them, which OVITO writes when it exports "
            "Radius; of equal grains give their radius, --radius R"
        );
    }
    if (size.at && source.radius) {
        reader.complain("the file contains radii, and one for all was given: leave that out");
    }
}

void read_cell(const LineReader& reader, const std::string& file, std::string_view head, ImportedPacking& packing) {
    const std::string_view lattice = value_of(head, "Lattice");
    if (lattice.empty()) {
        return;
    }
    const auto numbers = split_at_blanks(lattice);
    if (numbers.size() != 9) {
        reader.complain(fmt::format("Lattice: found {} numbers, expected nine", numbers.size()));
    }
    Mat3 h;
    for (std::size_t k = 0; k < 9; ++k) { // vector after vector
        h(static_cast<int>(k % 3), static_cast<int>(k / 3)) = to_number(reader, numbers[k], "Lattice");
    }
    if (!(determinant(h) > 0)) {
        reader.complain("Lattice: its vectors span no volume, expected three vectors, right-handed");
    }
    const auto periodic = split_at_blanks(value_of(head, "pbc"));
    for (std::size_t axis = 0; axis < std::min<std::size_t>(periodic.size(), 3); ++axis) {
        if (periodic[axis].starts_with('F') || periodic[axis] == "0") {
            packing.no_cell = not_periodic(file, reader.number(), fmt::format("pbc {}", periodic[axis]), axis);
            return;
        }
    }
    packing.cell = cell::Cell{h, {}};
}

} // namespace

bool looks_like_extended_xyz(std::string_view text) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) {
        return false;
    }
    const std::string_view second = text.substr(end + 1, text.find('\n', end + 1) - end - 1);
    return second.find("Properties=") != std::string_view::npos;
}

ImportedPacking parse_extended_xyz(const PackingSource& source) {
    LineReader reader(source.file, source.text);
    reader.next();
    const std::size_t rows = to_count(reader, reader.line(), "number of particles");
    reader.next();
    const std::string head(reader.line());
    const Layout layout = read_layout(reader, value_of(head, "Properties"));
    const auto position = layout.find("pos", 3);
    const SizeColumn size = find_size(layout);
    check_layout(reader, source, position.has_value(), size);
    const auto velocity = layout.find("velo", 3), spin = layout.find("angular_velocity", 3),
               fine = layout.find("fine", 1);
    ImportedPacking packing;
    read_cell(reader, source.file, head, packing);
    Vec3 origin;
    if (const auto given = split_at_blanks(value_of(head, "Origin")); given.size() == 3) {
        origin = vector_in(reader, given, {0, 1, 2});
        packing.origin = origin;
    }
    for (std::size_t row = 0; row < rows; ++row) {
        if (!reader.next()) {
            reader.complain(fmt::format("the file ends after {} particles, expected {}", row, rows));
        }
        const auto f = split_at_blanks(reader.line());
        if (f.size() != layout.name.size()) {
            reader.complain(fmt::format("found {} fields, expected {}", f.size(), layout.name.size()));
        }
        const Vec3 x = vector_in(reader, f, three_from(*position));
        const double r =
            size.at ? size.to_radius * positive_in(reader, f[*size.at], size.name) : source.radius.value_or(0);
        const auto g = grains::add_grain(packing.grains, x - origin, r, source.density);
        packing.grains.velocity[g] = velocity ? vector_in(reader, f, three_from(*velocity)) : Vec3{};
        packing.grains.spin[g] = spin ? vector_in(reader, f, three_from(*spin)) : Vec3{};
        packing.grains.fine[g] = fine && to_number(reader, f[*fine], "fine") != 0 ? 1 : 0;
    }
    if (reader.next()) {
        packing.warnings.push_back(fmt::format("{}:{}: only the first frame is read", source.file, reader.number()));
    }
    return packing;
}

} // namespace suffuse::io
