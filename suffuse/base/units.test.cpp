#include "suffuse/base/units.hpp"

#include "suffuse/base/constants.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using suffuse::parse_quantity;
using suffuse::print_quantity;
namespace dimension = suffuse::dimension;

std::string message_of(const std::string& text, suffuse::Dimension wanted) {
    try {
        parse_quantity(text, wanted);
    } catch (const suffuse::UnitError& error) {
        return std::string(error.what()) + " | " + error.help;
    }
    return "no error";
}

// Decimal prefixes are exact, so plain equality holds throughout.
TEST(Units, EachUnitHasItsSizeAndDimension) {
    EXPECT_EQ(parse_quantity("100 kPa", dimension::pressure), 1e5);
    EXPECT_EQ(parse_quantity("356 MPa", dimension::pressure), 356e6);
    EXPECT_EQ(parse_quantity("1 GPa", dimension::pressure), 1e9);
    EXPECT_EQ(parse_quantity("2 bar", dimension::pressure), 2e5);
    EXPECT_EQ(parse_quantity("0.26 mm", dimension::length), 2.6e-4);
    EXPECT_EQ(parse_quantity("75 um", dimension::length), 75e-6);
    EXPECT_EQ(parse_quantity("75 \u00b5m", dimension::length), 75e-6);
    EXPECT_EQ(parse_quantity("75 \u03bcm", dimension::length), 75e-6);
    EXPECT_EQ(parse_quantity("2 cm", dimension::length), 0.02);
    EXPECT_EQ(parse_quantity("1.5 km", dimension::length), 1500);
    EXPECT_EQ(parse_quantity("10 min", dimension::time), 600);
    EXPECT_EQ(parse_quantity("2 h", dimension::time), 7200);
    EXPECT_EQ(parse_quantity("4.1e-8 s", dimension::time), 4.1e-8);
    EXPECT_EQ(parse_quantity("41 us", dimension::time), 41e-6);
    EXPECT_EQ(parse_quantity("1 mPa*s", dimension::viscosity), 1e-3);
    EXPECT_EQ(parse_quantity("2650 kg/m^3", dimension::density), 2650);
    EXPECT_EQ(parse_quantity("2650 kg/m3", dimension::density), 2650);
    EXPECT_EQ(parse_quantity("2650 kg/m\u00b3", dimension::density), 2650);
    EXPECT_EQ(parse_quantity("2.65 g/cm^3", dimension::density), 2650);
    EXPECT_EQ(parse_quantity("2.65 t/m^3", dimension::density), 2650);
    EXPECT_EQ(parse_quantity("37 deg", dimension::angle), suffuse::radians(37));
    EXPECT_EQ(parse_quantity("37\u00b0", dimension::angle), suffuse::radians(37));
    EXPECT_EQ(parse_quantity("0.5 rad", dimension::angle), 0.5);
    EXPECT_EQ(parse_quantity("20 %", dimension::none), 0.2);
    EXPECT_EQ(parse_quantity("10 1/s", dimension::rate), 10);
    EXPECT_EQ(parse_quantity("10/s", dimension::rate), 10);
    EXPECT_EQ(parse_quantity("10 s^-1", dimension::rate), 10);
    EXPECT_EQ(parse_quantity("0.0063 kg/m", dimension::mass_per_length), 0.0063);
    EXPECT_EQ(parse_quantity("1e-5 m/s", dimension::velocity), 1e-5);
    EXPECT_EQ(parse_quantity("3 kN", dimension::force), 3000);
    EXPECT_EQ(parse_quantity("5 N/mm^2", dimension::pressure), 5e6);
    EXPECT_EQ(parse_quantity("1_000.5 Pa", dimension::pressure), 1000.5);
    EXPECT_EQ(parse_quantity("-.5e2 Pa", dimension::pressure), -50);
}

TEST(Units, ChangeOfUnitChangesNoBit) {
    EXPECT_EQ(parse_quantity("0.26 mm").value, parse_quantity("260 um").value);
    EXPECT_EQ(parse_quantity("0.26 mm").value, parse_quantity("2.6e-4 m").value);
    EXPECT_EQ(parse_quantity("0.1 MPa").value, parse_quantity("100 kPa").value);
    EXPECT_EQ(parse_quantity("0.3 %").value, parse_quantity("0.003").value);
}

TEST(Units, AUnitHasItsNumberOrNone) {
    EXPECT_EQ(suffuse::parse_unit("mm", dimension::length), 1e-3);
    EXPECT_EQ(suffuse::parse_unit("1 mm", dimension::length), 1e-3);
    EXPECT_EQ(suffuse::parse_unit(" 10um", dimension::length), 1e-5);
    EXPECT_EQ(suffuse::parse_unit("kg/m^3", dimension::density), 1);
    EXPECT_EQ(suffuse::parse_unit("1/s", dimension::rate), 1);
    for (const char* const none : {"", "1", "kPa", "0 mm", "-1 mm", "inch"}) {
        EXPECT_THROW(suffuse::parse_unit(none, dimension::length), suffuse::UnitError) << none;
    }
}

TEST(Units, ARatioMayBeAQuotient) {
    EXPECT_EQ(parse_quantity("12 m / 30 m", dimension::none), 0.4);
    EXPECT_EQ(parse_quantity("12m/30m", dimension::none), 0.4);
    EXPECT_EQ(parse_quantity("300 mm / 1 m", dimension::none), 0.3);
    EXPECT_EQ(parse_quantity("1/4", dimension::none), 0.25);
    EXPECT_EQ(parse_quantity("30 1/s / 60 1/s", dimension::none), 0.5);
    EXPECT_EQ(parse_quantity("3 1/s", dimension::rate), 3); // a unit is none
    EXPECT_EQ(
        message_of("12 m / 30", dimension::none),
        "\"12 m / 30\" divides a length by a ratio, a ratio is expected | write both in units of one kind, as in "
        "\"12 m / 30 m\""
    );
    EXPECT_EQ(message_of("1/0", dimension::none), "\"1/0\" divides by nothing | write a divisor above 0");
}

TEST(Units, ErrorsSayWhatIsWrongAndWhatToDo) {
    EXPECT_EQ(message_of("100 kpq*", dimension::pressure).substr(0, 12), "unknown unit");
    EXPECT_EQ(
        message_of("100 kPaa", dimension::pressure),
        "unknown unit \"kPaa\" | a unit with a similar name exists: \"kPa\""
    );
    EXPECT_EQ(parse_quantity("100 kpa", dimension::pressure), 1e5); // no other unit differs by capitals alone
    EXPECT_EQ(parse_quantity("100 KPa", dimension::pressure), 1e5);
    EXPECT_EQ(
        message_of("356 mpa", dimension::pressure),
        "unknown unit \"mpa\" | units with similar names exist: \"mPa\", \"MPa\""
    );
    EXPECT_EQ(
        message_of("356 MP", dimension::pressure),
        "unknown unit \"MP\" | units with similar names exist: \"mPa\", \"MPa\""
    );
    EXPECT_EQ(message_of("100", dimension::pressure), "\"100\" has no unit, a pressure is expected | write it in kPa");
    EXPECT_EQ(
        message_of("100 mm", dimension::pressure), "\"100 mm\" is a length, a pressure is expected | write it in kPa"
    );
    EXPECT_EQ(
        message_of("5 kPa", dimension::none),
        "\"5 kPa\" is a pressure, a ratio is expected | write a bare number, or one with %"
    );
    EXPECT_EQ(message_of("0,26 mm", dimension::length), "\"0,26 mm\" has a decimal comma | write a decimal point");
    EXPECT_NE(message_of("kPa", dimension::pressure).find("does not start with a number"), std::string::npos);
    EXPECT_NE(message_of("", dimension::pressure).find("does not start with a number"), std::string::npos);
    EXPECT_NE(message_of("nan Pa", dimension::pressure).find("does not start with a number"), std::string::npos);
    EXPECT_NE(message_of("1e999 Pa", dimension::pressure).find("beyond what a number can hold"), std::string::npos);
    EXPECT_NE(
        message_of("1e99999999999999999999 Pa", dimension::pressure).find("beyond what a number can hold"),
        std::string::npos
    );
    EXPECT_NE(message_of("1 m^12", dimension::length).find("power"), std::string::npos);
    EXPECT_NE(message_of("1 Pa*", dimension::pressure).find("is not a unit"), std::string::npos);
    EXPECT_NE(message_of("1 m//s", dimension::velocity).find("is not a unit"), std::string::npos);
}

TEST(Units, PrintingPicksAUsualUnitThatIsShort) {
    EXPECT_EQ(print_quantity(1e5, dimension::pressure), "100 kPa");
    EXPECT_EQ(print_quantity(356e6, dimension::pressure), "356 MPa");
    EXPECT_EQ(print_quantity(2.7e9, dimension::pressure), "2.7 GPa");
    EXPECT_EQ(print_quantity(7e10, dimension::pressure), "70 GPa");
    EXPECT_EQ(print_quantity(2.6e-4, dimension::length), "0.26 mm");
    EXPECT_EQ(print_quantity(1e-3, dimension::viscosity), "1 mPa*s");
    EXPECT_EQ(print_quantity(suffuse::radians(37), dimension::angle), "37 deg");
    EXPECT_EQ(print_quantity(suffuse::radians(10), dimension::angle), "10 deg");
    EXPECT_EQ(print_quantity(1000, dimension::density), "1000 kg/m^3");
    EXPECT_EQ(print_quantity(2600, dimension::density), "2600 kg/m^3");
    EXPECT_EQ(print_quantity(0, dimension::rate), "0 1/s");
    EXPECT_EQ(print_quantity(0.005, dimension::none), "0.005");
}

TEST(Units, AnErrorHasItsKind) {
    using Kind = suffuse::UnitError::Kind;
    for (const auto& [text, kind] : std::vector<std::pair<std::string, Kind>>{
             {"wide", Kind::NoNumber},
             {"3 parsec", Kind::UnknownUnit},
             {"3 )", Kind::UnknownUnit},
             {"3 m^22", Kind::Malformed},
             {"3,5 m", Kind::Malformed},
             {"3 m / 2 s", Kind::Malformed},
             {"3 m / 0 m", Kind::OutOfRange},
             {"1e999 m", Kind::OutOfRange},
             {"3", Kind::NoUnit},
             {"3 kPa", Kind::OtherDimension},
         }) {
        try {
            parse_quantity(text, dimension::length);
            ADD_FAILURE() << text;
        } catch (const suffuse::UnitError& error) {
            EXPECT_EQ(error.kind, kind) << error.what();
        }
    }
}

TEST(Units, PrintingAndReadingGiveTheSameBits) {
    const std::vector<suffuse::Dimension> all{
        dimension::none,     dimension::length,          dimension::time,     dimension::mass,      dimension::angle,
        dimension::rate,     dimension::force,           dimension::velocity, dimension::viscosity, dimension::density,
        dimension::pressure, dimension::mass_per_length, {2, 1, -3, 0}};
    std::mt19937_64 random(1);
    int checked = 0;
    while (checked < 20'000) {
        const auto value = std::bit_cast<double>(random());
        // Within what prefixes can shift without leaving the range of a double.
        if (!std::isfinite(value) || std::abs(value) < 1e-280 || std::abs(value) > 1e280) {
            continue;
        }
        // Every other value has few digits, as what people write.
        const double x = checked % 2 == 0 ? value : std::round(std::fmod(value, 1000) * 100) * 1e-5;
        const suffuse::Dimension dimension = all[random() % all.size()];
        const double back = parse_quantity(print_quantity(x, dimension), dimension);
        ASSERT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(x)) << print_quantity(x, dimension);
        ++checked;
    }
}

} // namespace
