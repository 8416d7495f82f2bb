#pragma once
// Rows of a text table whose columns have names: which column a field comes from, and grains made of the fields.

#include "suffuse/base/vec3.hpp"
#include "suffuse/io/packing_file.hpp"
#include "suffuse/io/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::io {

/// Columns of a vector: of x, y, z in that order.
using VectorColumns = std::array<std::size_t, 3>;

class NamedColumns {
public:
    explicit NamedColumns(std::vector<std::string_view> names) : names_(std::move(names)) {}

    [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const {
        const auto at = std::find(names_.begin(), names_.end(), name);
        return at == names_.end() ? std::nullopt : std::optional<std::size_t>(at - names_.begin());
    }

    [[nodiscard]] std::optional<VectorColumns> find(std::string_view x, std::string_view y, std::string_view z) const {
        const auto a = find(x), b = find(y), c = find(z);
        return a && b && c ? std::optional(VectorColumns{*a, *b, *c}) : std::nullopt;
    }

private:
    std::vector<std::string_view> names_;
};

inline Vec3
vector_in(const LineReader& reader, const std::vector<std::string_view>& fields, const VectorColumns& columns) {
    return {
        to_number(reader, fields[columns[0]], "x"), to_number(reader, fields[columns[1]], "y"),
        to_number(reader, fields[columns[2]], "z")};
}

/// A radius; complains unless it is positive.
inline double positive_in(const LineReader& reader, std::string_view field, std::string_view column) {
    const double value = to_number(reader, field, column);
    if (!(value > 0)) {
        reader.complain(
            std::string("found ") + std::string(column) + " " + std::string(field) + ", expected a positive one"
        );
    }
    return value;
}

/// Why a box is no cell.
inline std::string not_periodic(const std::string& file, int line, std::string_view found, std::size_t axis) {
    return fmt::format(
        "{}:{}: found {} along {}, and samples must be periodic along all axes, so its box is not a cell", file, line,
        found, "xyz"[axis]
    );
}

} // namespace suffuse::io
