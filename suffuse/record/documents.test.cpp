#include "suffuse/record/documents.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace suffuse::record {
namespace {

using nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

/// Arrays within each other.
std::string nested(std::size_t levels) {
    return std::string(levels, '[') + std::string(levels, ']');
}

/// The same in CBOR: 0x81 is an array of one value, 0x80 one of none.
Bytes nested_cbor(std::size_t levels) {
    Bytes bytes(levels, 0x81);
    bytes.back() = 0x80;
    return bytes;
}

TEST(Documents, AreReadAsTheyWereWritten) {
    const json document = {{"a", {1, 2.5, nullptr, true}}, {"b", {{"c", "word"}}}};
    EXPECT_EQ(parse_json(document.dump()), document);
    EXPECT_EQ(parse_cbor(json::to_cbor(document)), document);
}

TEST(Documents, ThatAreNoneAreDiscarded) {
    for (const char* text : {"", "{", "[1,]", "{} {}", "1e999"}) {
        EXPECT_TRUE(parse_json(text).is_discarded()) << text;
    }
    for (const Bytes& bytes : {Bytes{}, Bytes{0x81}, Bytes{0xff}, Bytes{0x80, 0x80}}) {
        EXPECT_TRUE(parse_cbor(bytes).is_discarded());
    }
}

// A million brackets are a small file, and more levels than a stack has room for.
TEST(Documents, NestedWithoutEndAreDiscarded) {
    EXPECT_FALSE(parse_json(nested(64)).is_discarded());
    EXPECT_FALSE(parse_cbor(nested_cbor(64)).is_discarded());
    for (const std::size_t levels : {65, 1'000'000}) {
        EXPECT_TRUE(parse_json(nested(levels)).is_discarded()) << levels;
        EXPECT_TRUE(parse_cbor(nested_cbor(levels)).is_discarded()) << levels;
    }
}

} // namespace
} // namespace suffuse::record
