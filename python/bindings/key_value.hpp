#pragma once
// Values of what a case file can say too, in the range that the case has for the key.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema.hpp"

#include <fmt/format.h>

#include "python/bindings/convert.hpp"
#include <array>
#include <cstdint>
#include <optional>
#include <string>
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

/// What a word of a case stands for. @param key whose word it is; names it in messages
template <class T, std::size_t N>
T word_of(const std::string& word, const std::array<casefile::names::Word<T>, N>& words, const char* key) {
    std::string all;
    for (const auto& [value, name] : words) {
        if (word == name) {
            return value;
        }
        all += fmt::format("{}{}", all.empty() ? "" : ", ", name);
    }
    throw CaseError(fmt::format("{}: found \"{}\", expected one of {}", key, word, all));
}

} // namespace suffuse::python
