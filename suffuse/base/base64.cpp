#include "suffuse/base/base64.hpp"

#include <algorithm>
#include <cstddef>
#include <openssl/evp.h>

namespace suffuse {
namespace {

constexpr std::size_t bytes_at_once = std::size_t{3} << 24; // OpenSSL counts in int

unsigned char* writable(std::string& text, std::size_t at) {
    return reinterpret_cast<unsigned char*>(text.data()) + at;
}

const unsigned char* readable(std::string_view text, std::size_t at) {
    return reinterpret_cast<const unsigned char*>(text.data()) + at;
}

} // namespace

std::string base64(std::string_view bytes) {
    std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0'); // OpenSSL ends it with a zero
    std::size_t written = 0;
    for (std::size_t at = 0; at < bytes.size(); at += bytes_at_once) {
        const std::size_t count = std::min(bytes_at_once, bytes.size() - at);
        written += static_cast<std::size_t>(
            EVP_EncodeBlock(writable(text, written), readable(bytes, at), static_cast<int>(count))
        );
    }
    text.resize(written);
    return text;
}

std::optional<std::string> from_base64(std::string_view text) {
    std::string letters;
    letters.reserve(text.size());
    std::copy_if(text.begin(), text.end(), std::back_inserter(letters), [](char c) {
        return c != '\n' && c != '\r' && c != ' ' && c != '\t';
    });
    constexpr std::string_view known = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
    if (letters.size() % 4 != 0 || letters.find_first_not_of(known) != std::string::npos) {
        return std::nullopt;
    }
    std::string bytes(letters.size() / 4 * 3, '\0');
    std::size_t written = 0;
    for (std::size_t at = 0; at < letters.size();) {
        // Up to the end of a group with padding: what follows begins anew.
        const std::size_t padded = std::min(letters.find('=', at), letters.size() - 1) / 4 * 4 + 4;
        const std::size_t end = std::min(padded, at + bytes_at_once);
        const std::string_view groups = std::string_view(letters).substr(at, end - at);
        const auto padding = static_cast<std::size_t>(std::count(groups.begin(), groups.end(), '='));
        const bool is_last = padding == 0 || (padding <= 2 && groups.find('=') == groups.size() - padding);
        const int count =
            is_last ? EVP_DecodeBlock(writable(bytes, written), readable(groups, 0), static_cast<int>(groups.size()))
                    : -1;
        if (count < 0) {
            return std::nullopt;
        }
        written += static_cast<std::size_t>(count) - padding;
        at = end;
    }
    bytes.resize(written);
    return bytes;
}

} // namespace suffuse
