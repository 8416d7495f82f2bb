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

/// Members that may be missing are null, both ways.
template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
    static void to_json(json& document, const std::optional<T>& value) { document = value ? json(*value) : json(); }

    static void from_json(const json& document, std::optional<T>& value) {
        value = document.is_null() ? std::optional<T>() : document.get<T>();
    }
};
