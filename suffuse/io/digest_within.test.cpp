#include "suffuse/io/digest_within.hpp"

#include <gtest/gtest.h>

namespace suffuse::io {
namespace {

constexpr std::size_t place = 100;
const std::string own(DigestWithin::digits, 'f');

std::string file_with(const std::string& digits) {
    return std::string(place, 'a') + digits + std::string(50, 'b');
}

TEST(DigestWithin, IsThatOfTheFileWithZerosInItsPlace) {
    Sha256 plain;
    plain.add(file_with(std::string(DigestWithin::digits, '0')));
    DigestWithin digest(place);
    digest.add(file_with(own));
    EXPECT_EQ(digest.recorded(), own);
    EXPECT_EQ(digest.found(), plain.hex());
}

TEST(DigestWithin, IsTheSameHoweverTheBytesCome) {
    const std::string bytes = file_with(own);
    DigestWithin whole(place);
    whole.add(bytes);
    const std::string expected = whole.found();
    for (std::size_t size = 1; size < bytes.size(); ++size) {
        DigestWithin parts(place);
        for (std::size_t at = 0; at < bytes.size(); at += size) {
            parts.add(std::string_view(bytes).substr(at, size));
        }
        EXPECT_EQ(parts.recorded(), own) << size;
        EXPECT_EQ(parts.found(), expected) << size;
    }
}

} // namespace
} // namespace suffuse::io
