#pragma once
// Contacts by the fractions that meet: large with large, large with small, small with small grains.

#include "suffuse/grains/grains.hpp"

#include <cstdint>

namespace suffuse::stats {

enum class ContactClass : std::uint8_t { LargeLarge, LargeSmall, SmallSmall };

/// One value a class of contacts.
template <class T>
struct PerClass {
    T large_large{}, large_small{}, small_small{};

    constexpr T& operator[](ContactClass k) {
        return k == ContactClass::LargeLarge ? large_large : k == ContactClass::LargeSmall ? large_small : small_small;
    }

    [[nodiscard]] constexpr T total() const { return large_large + large_small + small_small; }
};

/// Class of the contact between grains `i` and `j`: "small" are the grains of the fine fraction.
inline ContactClass class_of(const grains::Grains& grains, std::uint32_t i, std::uint32_t j) {
    return static_cast<ContactClass>((grains.fine[i] != 0 ? 1 : 0) + (grains.fine[j] != 0 ? 1 : 0));
}

} // namespace suffuse::stats
