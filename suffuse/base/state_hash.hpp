#pragma once
// An order-sensitive 64-bit hash of columns (FNV-1a over the bytes), for "the same bits" tests and for caches.

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace suffuse {

class StateHash {
public:
    template <class T>
    void add(std::span<const T> column) {
        for (const T& value : column) {
            add_bytes(&value, sizeof value);
        }
    }

    template <class T>
    void add(const T& value) {
        add_bytes(&value, sizeof value);
    }

    void add(std::string_view text) { add_bytes(text.data(), text.size()); }

    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    void add_bytes(const void* data, std::size_t count) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t k = 0; k < count; ++k) {
            value_ = (value_ ^ bytes[k]) * 1099511628211ULL;
        }
    }

    std::uint64_t value_ = 14695981039346656037ULL;
};

} // namespace suffuse
