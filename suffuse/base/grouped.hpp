#pragma once
// Counts as a reader takes them in.

#include <string>

namespace suffuse {

/// A whole number with thousands apart: 2,778.
inline std::string grouped(long long count) {
    std::string digits = std::to_string(count);
    const std::size_t sign = count < 0 ? 1 : 0;
    for (std::size_t at = digits.size(); at > sign + 3;) {
        at -= 3;
        digits.insert(at, 1, ',');
    }
    return digits;
}

} // namespace suffuse
