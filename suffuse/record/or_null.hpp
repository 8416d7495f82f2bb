#pragma once
// What does not exist, or is not finite, is null in a JSON document: it has no word for either.

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <type_traits>

namespace suffuse {

inline nlohmann::json or_null(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

template <class T>
nlohmann::json or_null(const std::optional<T>& value) {
    if constexpr (std::is_same_v<T, double>) {
        return value ? or_null(*value) : nlohmann::json();
    } else {
        return value ? nlohmann::json(*value) : nlohmann::json();
    }
}

} // namespace suffuse
