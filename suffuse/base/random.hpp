#pragma once
// Counter-based random numbers: Philox 4x32-10 [Salmon 2011]. A number is a pure function of (seed, purpose, index, how
// many were drawn before), so it does not matter which thread draws it or in which order; a seed is data. Distributions
// are written here because those of the standard library differ between its makers.

#include "suffuse/base/constants.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace suffuse {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// The Philox 4x32 bijection in ten rounds: four random words for each counter and key.
constexpr PhiloxCounter philox4x32(PhiloxCounter counter, PhiloxKey key) {
    constexpr int rounds = 10;
    for (int round = 0; round < rounds; ++round) {
        const std::uint64_t p = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t q = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {
            static_cast<std::uint32_t>(q >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(q),
            static_cast<std::uint32_t>(p >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(p)};
        key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};
    }
    return counter;
}

/// Independent streams of random numbers, one for each (seed, purpose, index); `purpose` names the use, "cloud" say.
class RandomStream {
public:
    constexpr RandomStream(std::uint64_t seed, std::string_view purpose, std::uint64_t index = 0)
        : key_{low(seed), high(seed)}, counter_{0, hash(purpose), low(index), high(index)} {}

    /// 32 random bits. A stream holds 2^34 of them before it repeats.
    constexpr std::uint32_t bits() {
        if (used_ == block_.size()) {
            block_ = philox4x32(counter_, key_);
            ++counter_[0];
            used_ = 0;
        }
        return block_[used_++];
    }

    /// Uniform in [0, 1), with all 53 bits of a double.
    constexpr double uniform() {
        const std::uint64_t first = bits() >> 5, second = bits() >> 6;
        return static_cast<double>((first << 26) | second) * 0x1p-53;
    }

    /// Uniform in [lowest, highest).
    constexpr double uniform(double lowest, double highest) { return lowest + (highest - lowest) * uniform(); }

    /// Standard normal, by Box and Muller; the second of each pair is dropped so that draws stay countable.
    double normal() {
        const double u = 1.0 - uniform(); // in (0, 1]: its logarithm is finite
        const double angle = 2.0 * pi * uniform();
        return std::sqrt(-2.0 * std::log(u)) * std::cos(angle);
    }

private:
    static constexpr std::uint32_t low(std::uint64_t v) { return static_cast<std::uint32_t>(v); }

    static constexpr std::uint32_t high(std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32); }

    static constexpr std::uint32_t hash(std::string_view text) { // FNV-1a
        std::uint32_t value = 2166136261U;
        for (const char c : text) {
            value = (value ^ static_cast<unsigned char>(c)) * 16777619U;
        }
        return value;
    }

    PhiloxKey key_;
    PhiloxCounter counter_;
    PhiloxCounter block_{};
    std::size_t used_ = block_.size();
};

} // namespace suffuse
