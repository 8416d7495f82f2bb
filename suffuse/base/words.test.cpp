#include "suffuse/base/words.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace suffuse {
namespace {

TEST(Words, NumbersKeepTheirDigitsAndLoseTrailingZeros) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(100), "100");
    EXPECT_EQ(short_number(2.0), "2");
    EXPECT_EQ(short_number(0.44753), "0.448");
    EXPECT_EQ(short_number(-72.04, 4), "−72.04");
    EXPECT_EQ(short_number(12345.6), "12300");
}

TEST(Words, PowersOfTenAreWrittenAsSuch) {
    EXPECT_EQ(short_number(1.371e-5), "1.37·10⁻⁵");
    EXPECT_EQ(short_number(-5e-11), "−5·10⁻¹¹");
    EXPECT_EQ(short_number(9.999e5), "1·10⁶");
    EXPECT_EQ(short_number(std::nan("")), "–");
    EXPECT_EQ(number_with_power(-1.785e-3), "−1.78·10⁻³");
    EXPECT_EQ(number_with_power(0.2), "2·10⁻¹");
}

TEST(Words, ANumberAndItsUnitStayOnOneLine) {
    EXPECT_EQ(kept_together("above 0.1 % at i = 0.05 in all"), "above 0.1\u00a0% at i\u00a0=\u00a00.05 in all");
    EXPECT_EQ(kept_together("at i < 0.01"), "at i\u00a0<\u00a00.01");
    EXPECT_EQ(kept_together("100 kPa, 2 mmx"), "100\u00a0kPa, 2 mmx");
    EXPECT_EQ(kept_together(" = "), " = ");
    EXPECT_EQ(kept_together(""), "");
}

TEST(Words, ASentenceBeginsWithACapital) {
    EXPECT_EQ(as_sentence("pass 1: n = 0.4"), "Pass 1: n = 0.4");
    EXPECT_EQ(as_sentence("ε"), "ε");
    EXPECT_EQ(as_sentence(""), "");
}

TEST(Words, AChangeBelowAHundredthOfAPercentIsNoise) {
    EXPECT_TRUE(is_noise(-9e-3) && is_noise(0));
    EXPECT_FALSE(is_noise(0.011) || is_noise(-1));
    EXPECT_EQ(percent_beyond_noise(9e-3), "< 0.01");
    EXPECT_EQ(percent_beyond_noise(0.0101), "0.01");
    EXPECT_EQ(percent_beyond_noise(-11.5), "−11.50");
}

} // namespace
} // namespace suffuse
