// Packings in the forms of other programs (tests/packings), and the page that lists the forms.

#include "suffuse/io/packing_readers.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/named_file.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/io/packing_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <string>

namespace suffuse::io {
namespace {

using test::TempFolder;

TakenPacking take_form(const std::string& name, std::optional<double> radius = {}) {
    PackingRequest request{.file = test::in_checkout("tests/packings/" + name)};
    request.radius = radius;
    request.cell = diagonal({3e-4, 3e-4, 5e-4});
    return take_packing(request);
}

TakenPacking take_text(const std::string& text, PackingRequest request = {}) {
    const TempFolder folder;
    write_file(folder / "p.any", text);
    request.file = folder / "p.any";
    return take_packing(request);
}

TakenPacking take_equal(const std::string& text, double radius) {
    PackingRequest request;
    request.radius = radius;
    return take_text(text, request);
}

std::string refusal(const std::string& text, std::optional<double> radius = {}, double unit = 1) {
    PackingRequest request;
    request.radius = radius;
    request.unit = unit;
    try {
        take_text(text, request);
    } catch (const CaseError& error) {
        const std::string message = error.what();
        return message.substr(message.find("p.any")); // without the folder
    }
    return "";
}

void expect_words(const std::string& words, const std::string& text) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

std::string warnings_of(const TakenPacking& taken) {
    return fmt::format("{}", fmt::join(taken.warnings, "\n"));
}

TEST(PackingReaders, EightFormsOfThreeGrainsAreTheSamePacking) {
    for (const std::string name :
         {"plain.xyz", "exadem.xyz", "comma-no-header.csv", "edem.csv", "pfc.csv", "mm-heading.csv",
          "paraview-position.csv", "kratos.mdpa"}) {
        const bool has_radii = !name.ends_with(".xyz");
        const TakenPacking taken = take_form(name, has_radii ? std::nullopt : std::optional(7e-5));
        ASSERT_EQ(taken.grains.size(), 3U) << name;
        for (const double r : taken.grains.radius) {
            EXPECT_DOUBLE_EQ(2 * r, 0.14e-3) << name;
        }
        EXPECT_DOUBLE_EQ(taken.grains.position[1].x, 2e-4) << name;
        EXPECT_DOUBLE_EQ(taken.grains.position[2].z, 3.5e-4) << name;
        EXPECT_NEAR(determinant(*taken.h) / grains::solid_volume(taken.grains) - 1, 9.44, 0.005) << name; // rounded
        EXPECT_EQ(taken.overlap, 0) << name;
        EXPECT_EQ(taken.contacts, 0U) << name;
    }
}

TEST(PackingReaders, PlainXyzHasNoRadiiAndSaysWhatIsMissing) {
    const std::string rows = "\nA 1 2 3\nA 3 2 1\n";
    EXPECT_EQ(take_equal("2\n\n" + rows.substr(1), 0.5).grains.position[1], (Vec3{3, 2, 1}));
    EXPECT_EQ(take_equal("2\n# by hand\n1 2 3\n3 2 1\n", 0.5).grains.position[0], (Vec3{1, 2, 3}));
    expect_words(
        "p.any:3: plain XYZ has no radii; of equal grains give their radius, --radius R", refusal("2\nt" + rows)
    );
    expect_words("which may be the radius", refusal("1\nt\nA 1 2 3 0.5\n"));
    expect_words("found 4 numbers: the kind of the grain and x y z, or x y z r", refusal("1\nt\n1 2 3 0.5\n"));
    expect_words("x y z r, perhaps", refusal("1\nt\n1.5 2 3 0.5\n", 0.5));
    expect_words("the file ends after 2 grains, expected 3", refusal("3\nt" + rows, 0.5));
    expect_words("only the first frame is read", warnings_of(take_equal("1\nt\nA 1 2 3\n1\nt\nA 1 2 3\n", 0.5)));
    expect_words("the columns behind x y z are ignored", warnings_of(take_equal("1\nt\nA 1 2 3 9 9 9\n", 0.5)));
}

TEST(PackingReaders, ThreeLengthsInLineTwoOfAnXyzFileAreItsBox) {
    const TakenPacking taken = take_equal("1\n4 5 6\n0 1 2 3\n", 0.5);
    EXPECT_EQ(taken.h, diagonal({4, 5, 6}));
    expect_words("p.any:2: its box is taken as the periodic cell", warnings_of(taken));
    EXPECT_FALSE(take_equal("1\n4 5 6 pbc\n0 1 2 3\n", 0.5).h);
}

TEST(PackingReaders, ExtendedXyzMayHaveDiametersOrOneRadiusForAll) {
    const std::string head = "1\nProperties=species:S:1:pos:R:3";
    EXPECT_EQ(take_text(head + ":diameter:R:1\nA 1 2 3 0.5\n").grains.radius[0], 0.25);
    EXPECT_EQ(take_equal(head + "\nA 1 2 3\n", 0.5).grains.radius[0], 0.5);
    expect_words("of equal grains give their radius, --radius R", refusal(head + "\nA 1 2 3\n"));
    expect_words("leave that out", refusal(head + ":radius:R:1\nA 1 2 3 0.5\n", 0.5));
}

TEST(PackingReaders, AFormatWithOwnRadiiRefusesOneForAll) {
    expect_words("leave that out", refusal("1 0 0 0 0 9 9 9\n1 2 3 0 0 0 .5 0 0 0 0 0 0 0\n", 0.5));
}

TEST(PackingReaders, HeadingsOfOtherProgramsNameColumns) {
    for (const std::string heading :
         {"Position X (m),Position Y (m),Position Z (m),Radius (m)", "pos-x,pos-y,pos-z,rad",
          "x_position,y_position,z_position,r", "position:0,position:1,position:2,Radius", "posx,posy,posz,radii",
          "x_m,y_m,z_m,r_m", "Center X,Center Y,Center Z,r"}) {
        const TakenPacking taken = take_text(heading + "\n1,2,3,0.5\n");
        EXPECT_EQ(taken.grains.position[0], (Vec3{1, 2, 3})) << heading;
        EXPECT_EQ(taken.grains.radius[0], 0.5) << heading;
    }
    const TakenPacking moving = take_text(
        "x,y,z,r,Velocity X (m/s),Velocity Y (m/s),Velocity Z (m/s),omega_0,omega_1,omega_2\n1,2,3,.5,4,5,6,7,8,9\n"
    );
    EXPECT_EQ(moving.grains.velocity[0], (Vec3{4, 5, 6}));
    EXPECT_EQ(moving.grains.spin[0], (Vec3{7, 8, 9}));
}

TEST(PackingReaders, UnitsInHeadingsBelongToTheirColumns) {
    const TakenPacking taken = take_text("X (mm);Y [cm];Z (m);Diameter (um);vx [mm/s];vy [mm/s];vz [mm/s]\n"
                                         "1;2;3;500;4;5;6\n");
    EXPECT_DOUBLE_EQ(taken.grains.position[0].x, 1e-3);
    EXPECT_DOUBLE_EQ(taken.grains.position[0].y, 2e-2);
    EXPECT_DOUBLE_EQ(taken.grains.position[0].z, 3);
    EXPECT_DOUBLE_EQ(taken.grains.radius[0], 250e-6);
    EXPECT_DOUBLE_EQ(taken.grains.velocity[0].z, 6e-3);
    expect_words("p.any:1: lengths are in cm, mm, um, as the headings say", warnings_of(taken));
    expect_words(
        "column d (mm) has a unit and column z has none: it may be in that unit or in m",
        refusal("x,y,z,d (mm)\n1,2,3,0.5\n")
    );
    expect_words(
        "column X (mm) is in mm by its heading, and the unit given is 1e-06 m",
        refusal("X (mm),Y (mm),Z (mm),r (mm)\n1,2,3,.5\n", {}, 1e-6)
    );
    EXPECT_DOUBLE_EQ(take_text("X (mm),Y (mm),Z (mm),r (mm)\n1,2,3,.5\n", {.unit = 1e-3}).grains.position[0].z, 3e-3);
    expect_words("found the unit \"px\", expected one of length, such as mm", refusal("x (px),y,z,r\n1,2,3,.5\n"));
}

TEST(PackingReaders, ATableWithoutHeadingsMayHaveCommas) {
    EXPECT_EQ(take_text("1,2,3,0.5\n4,5,6,0.25\n").grains.radius[1], 0.25);
    EXPECT_EQ(take_text("1;2;3;0.5;9\n").grains.radius[0], 0.5);
    EXPECT_EQ(take_text("# r, x, y, z\n0.5, 1, 2, 3\n").grains.position[0], (Vec3{1, 2, 3})); // numpy.savetxt
    EXPECT_EQ(take_text("# r,x,y,z\n0.5,1,2,3\n").grains.radius[0], 0.5);
    expect_words("p.any:1: column x: found \"0,5\", expected a finite number with a", refusal("0,5;1,5;2;0,1\n"));
    expect_words("or a heading that counts the columns", refusal("0,1,2,3\n1,2,3,0.5\n")); // pandas
}

TEST(PackingReaders, WholeNumbersInTheFirstColumnAreNotTakenForX) {
    EXPECT_EQ(take_equal("1 .1 .2 .3\n2 .4 .5 .6\n", 0.01).grains.position[1], (Vec3{.4, .5, .6})); // id x y z
    expect_words("may be x, or the number or kind of the grain", refusal("5 .1 .2 .3 .01\n9 .4 .5 .6 .01\n"));
    expect_words("may be x, or the number or kind of the grain", refusal("1 1 .1 .2 .3 .01\n2 1 .4 .5 .6 .01\n"));
    expect_words("column 1 counts the rows", refusal("1,.1,.2,.3\n2,.4,.5,.6\n"));
    EXPECT_EQ(take_text("# x y z r\n1 .1 .2 .3\n2 .4 .5 .6\n").grains.radius[0], .3);
    EXPECT_EQ(
        take_text("# id type x y z r\n5 1 .1 .2 .3 .01\n9 1 .4 .5 .6 .01\n").grains.position[1], (Vec3{.4, .5, .6})
    );
}

TEST(PackingReaders, UnitsBetweenBlanksBelongToTheWordBefore) {
    const TakenPacking taken = take_text("x [mm] y [mm] z [mm] r (mm)\n1 2 3 0.5\n");
    EXPECT_DOUBLE_EQ(taken.grains.position[0].z, 3e-3);
    EXPECT_DOUBLE_EQ(taken.grains.radius[0], 0.5e-3);
}

TEST(PackingReaders, SixColumnsAreThoseOfMfixWhereThePhaseCannotBeARadius) {
    const TakenPacking mfix = take_text(test::read_all(test::in_checkout("tests/packings/mfix-particle_input.dat")));
    ASSERT_EQ(mfix.grains.size(), 3U);
    EXPECT_DOUBLE_EQ(2 * mfix.grains.radius[0], 5e-3); // column 5 of the file
    EXPECT_DOUBLE_EQ(mfix.grains.position[2].z, 0.75e-2);
    expect_words("read as x y z phase diameter density of MFIX", warnings_of(mfix));
    const std::string far = "0 0 0 1 0.5 1000\n99 99 99 1 0.5 1000\n"; // as spheres of radius 1 and of 0.25 m
    expect_words("column 4 may be the radius, or the phase of MFIX", refusal(far));
    EXPECT_EQ(take_text("# x y z r a b\n" + far).grains.radius[0], 1);
    EXPECT_EQ(take_text("# x y z phase diameter density\n" + far).grains.radius[0], 0.25);
    EXPECT_EQ(take_text("0.5 0 0 1 0 0\n9 9 9 1 0 0\n").grains.radius[0], 1); // no diameter is 0
}

TEST(PackingReaders, KratosNodesAndRadiiBelongTogether) {
    const auto file = [](const std::string& radii) {
        return "// two spheres\nBegin Properties 1\n  Begin Table 1 2\n  0 0\n  End Table\nEnd Properties\nBegin Nodes "
               "// x y z\n"
               "7 1 2 3\n3 4 5 6\nEnd Nodes\n" +
               radii;
    };
    const std::string both = "Begin NodalData RADIUS\n3 0 0.5\n7 0 0.25\nEnd NodalData\n";
    const TakenPacking taken = take_text(file(both + "Begin NodalData VELOCITY_X\n3 0 1\nEnd NodalData\n"));
    EXPECT_EQ(taken.grains.radius, (std::vector<double>{0.25, 0.5}));
    EXPECT_EQ(taken.grains.position[1], (Vec3{4, 5, 6}));
    expect_words("NodalData VELOCITY_X is not read", warnings_of(taken));
    EXPECT_EQ(take_equal(file(""), 0.125).grains.radius[1], 0.125);
    expect_words("node 7 has no radius", refusal(file("Begin NodalData RADIUS\n3 0 0.5\nEnd NodalData\n")));
    expect_words("node 8, which Nodes does not have", refusal(file("Begin NodalData RADIUS\n8 0 1\nEnd NodalData\n")));
    expect_words(
        "the radius of node 3 occurs twice", refusal(file("Begin NodalData RADIUS\n3 0 1\n3 0 1\nEnd NodalData\n"))
    );
    expect_words("leave that out", refusal(file(both), 0.5));
    expect_words("the file ends, expected End NodalData", refusal(file("Begin NodalData RADIUS\n3 0 0.5\n")));
}

TEST(PackingReaders, FilesThatAreNoTextAreNamedByTheirFirstBytes) {
    for (const NamedFile& kind : named_files()) {
        const std::string message = refusal(std::string(kind.begin) + "\x01\x02");
        expect_words(fmt::format("p.any: this file is {};", kind.name), message);
        EXPECT_EQ(message.find("{}"), std::string::npos) << message;
    }
    EXPECT_THROW(take_form("magic.gsd"), CaseError);
    expect_words("bunzip2 -k", refusal("BZh91AY&SY"));
}

TEST(PackingReaders, ThePageListsEveryForm) {
    const std::string page = test::read_all(test::in_checkout("docs/packings.md"));
    const auto expect_row = [&page](const std::string& row) {
        EXPECT_NE(page.find("\n" + row + "\n"), std::string::npos) << "docs/packings.md lacks\n" << row;
    };
    for (const PackingReader& reader : packing_readers()) {
        expect_row(fmt::format("| {} | {} | {} | {} |", reader.name, reader.recognized, reader.columns, reader.cell));
    }
    for (const ColumnWords& row : column_words()) {
        expect_row(fmt::format("| {} | `{}` |", row.meaning, fmt::join(row.words, "`, `")));
    }
    for (const NamedFile& kind : named_files()) {
        std::string advice(kind.advice);
        const std::size_t at = advice.find("{}");
        expect_row(
            fmt::format("| {} | {} |", kind.name, at == std::string::npos ? advice : advice.replace(at, 2, "FILE"))
        );
    }
}

} // namespace
} // namespace suffuse::io
