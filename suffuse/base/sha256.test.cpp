#include "suffuse/base/sha256.hpp"

#include <gtest/gtest.h>

namespace suffuse {
namespace {

std::string sha256(std::string_view text) {
    Sha256 hash;
    hash.add(text);
    return hash.hex();
}

TEST(Sha256, MeetsThePublishedExamples) {
    // FIPS 180-4's examples of one and two blocks, the empty text, and a million letters a.
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(
        sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"
    );
    EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, IsTheSameHoweverTheBytesCome) {
    const std::string text(1000, 'x');
    Sha256 hash;
    for (std::size_t at = 0, size = 1; at < text.size(); at += size, size = size % 97 + 1) {
        hash.add(std::string_view(text).substr(at, size));
    }
    EXPECT_EQ(hash.hex(), sha256(text));
}

} // namespace
} // namespace suffuse
