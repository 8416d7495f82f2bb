#pragma once
// Numbers off the front of an input: the same bytes make the same choices, and a few of them make many.

#include <cstddef>
#include <cstdint>

namespace suffuse::fuzz {

/// Zeros where the bytes have ended.
struct Bytes {
    const std::uint8_t* at;
    std::size_t left;

    std::uint8_t next() {
        if (left == 0) {
            return 0;
        }
        --left;
        return *at++;
    }

    /// Below 65,536.
    std::size_t next_pair() {
        const std::size_t high = next();
        return (high << 8U) | next();
    }
};

} // namespace suffuse::fuzz
