#pragma once
// Values of what a case file can say too, in the range that the case has for the key.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/schema.hpp"

#include <fmt/format.h>

#include "python/bindings/convert.hpp"
#include <cstdint>
#include <optional>
#include <string_view>

namespace suffuse::python {

/// A number in SI, or a text with its unit. @param name of the argument, in messages. @throws CaseError, UnitError.
inline double value_of(const casefile::Key& key, const py::handle& value, std::string_view name) {
    const double number = quantity_of(value, key.dimension, name);
    if (!key.range.contains(number)) {
        throw CaseError(fmt::format(
            "{}: found {}, expected it to be {}; a bare number is in SI", name, print_quantity(number, key.dimension),
            casefile::range_text(key)
        ));
    }
    return number;
}

/// A whole number.
inline std::int64_t count_of(const casefile::Key& key, std::int64_t value, std::string_view name) {
    if (!key.range.contains(static_cast<double>(value))) {
        throw CaseError(fmt::format("{}: found {}, expected it to be {}", name, value, casefile::range_text(key)));
    }
    return value;
}

/// Nothing for None.
inline std::optional<double>
optional_value_of(const casefile::Key& key, const py::handle& value, std::string_view name) {
    return value.is_none() ? std::nullopt : std::optional(value_of(key, value, name));
}

} // namespace suffuse::python
