#include "suffuse/base/byte_size.hpp"

#include "suffuse/base/units.hpp"

#include <gtest/gtest.h>

namespace suffuse {
namespace {

TEST(ByteSize, IsReadInDecimalAndInBinaryUnits) {
    EXPECT_EQ(parse_byte_size("16GB"), 16e9);
    EXPECT_EQ(parse_byte_size("1.5 TB"), 1.5e12);
    EXPECT_EQ(parse_byte_size("2GiB"), 2147483648.0);
    EXPECT_EQ(parse_byte_size("512 KiB"), 524288.0);
    EXPECT_EQ(parse_byte_size("7B"), 7.0);
}

TEST(ByteSize, WithoutNumberOrUnitIsRefusedWithAdvice) {
    for (const char* const text : {"", "GB", "-1GB", "0GB", "nan GB", "16", "16 gb", "16 m", "1e400GB"}) {
        try {
            parse_byte_size(text);
            ADD_FAILURE() << text << " was taken";
        } catch (const UnitError& error) {
            EXPECT_NE(error.help.find("GB"), std::string::npos) << text;
        }
    }
}

TEST(ByteSize, AdviceNamesTheUnitThatWasMeant) {
    for (const auto& [text, advice] : std::initializer_list<std::pair<const char*, const char*>>{
             {"512 mb", "512MB"},
             {"2K", "2kB"},
             {"2 k", "2kB"},
             {"16g", "16GB"},
             {"1.5 gib", "1.5GiB"},
             {"3 T", "3TB"},
             {"4 Mi", "4MiB"},
             {"16", "16GB"},
             {"1,5 GB", "a decimal point, as in 1.5 GB"},
             {"0,5GB", "a decimal point, as in 0.5GB"},
             {"1,5 gb", "1.5GB"}}) {
        try {
            parse_byte_size(text);
            ADD_FAILURE() << text << " was taken";
        } catch (const UnitError& error) {
            EXPECT_TRUE(error.help.starts_with(std::string("write ") + advice)) << text << ": " << error.help;
        }
    }
}

} // namespace
} // namespace suffuse
