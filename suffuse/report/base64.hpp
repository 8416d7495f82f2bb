#pragma once
// Base64 [RFC 4648], for bytes inside a page.

#include <cstdint>
#include <string>
#include <string_view>

namespace suffuse::report {

inline std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t three = 0;
        const std::size_t there = std::min<std::size_t>(3, bytes.size() - k);
        for (std::size_t b = 0; b < 3; ++b) {
            three = three << 8 | (b < there ? static_cast<std::uint8_t>(bytes[k + b]) : 0U);
        }
        for (std::size_t c = 0; c < 4; ++c) {
            out += c <= there ? letters[three >> (18 - 6 * c) & 63] : '=';
        }
    }
    return out;
}

} // namespace suffuse::report
