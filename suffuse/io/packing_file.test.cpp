#include "suffuse/io/packing_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/io/packing_export.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <bit>
#include <cmath>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <zlib.h>

namespace suffuse::io {
namespace {

using test::TempFolder;
using namespace std::string_literals;

ImportedPacking parse(const std::string& text) {
    const TempFolder folder;
    write_file(folder / "p.csv", text);
    return read_packing(folder / "p.csv", 2600);
}

std::string complaint(const std::string& text) {
    try {
        parse(text);
    } catch (const CaseError& error) {
        const std::string message = error.what();
        return message.substr(message.find("p.csv")); // without the folder
    }
    return "";
}

TEST(PackingFile, CsvColumnsMayComeInAnyOrderAndOthersAreIgnoredWithAWarning) {
    const ImportedPacking packing = parse("# from somewhere\r\nr, z,y,x,color\r\n\r\n0.5,3,2,1,red\r\n0.25,6,5,4,blue");
    ASSERT_EQ(packing.grains.size(), 2U);
    EXPECT_EQ(packing.grains.position[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(packing.grains.position[1], (Vec3{4, 5, 6}));
    EXPECT_EQ(packing.grains.radius[1], 0.25);
    EXPECT_DOUBLE_EQ(packing.grains.mass[0], 2600 * sphere_volume(0.5));
    EXPECT_FALSE(packing.cell.has_value());
    ASSERT_EQ(packing.warnings.size(), 1U);
    EXPECT_NE(packing.warnings[0].find("p.csv:2: column \"color\" ignored"), std::string::npos);
}

TEST(PackingFile, TextsMadeToFillMemoryAreRefusedWithASentence) {
    const TempFolder folder;
    const auto refusal = [&folder](const std::string& name) -> std::string {
        try {
            read_packing(folder / name, 2600);
        } catch (const std::exception& error) {
            return error.what();
        }
        return "";
    };
    const std::string block(std::size_t{1} << 20U, '1');
    const gzFile bomb = gzopen((folder / "bomb.csv.gz").c_str(), "wb9");
    for (int k = 0; k < 80; ++k) { // 80 MiB of one digit are 80 KiB
        ASSERT_EQ(gzwrite(bomb, block.data(), static_cast<unsigned>(block.size())), static_cast<int>(block.size()));
    }
    ASSERT_EQ(gzclose(bomb), Z_OK);
    EXPECT_NE(refusal("bomb.csv.gz").find("unpacks to more than 100 times its size"), std::string::npos);
    std::filesystem::create_symlink("/dev/zero", folder / "zero.csv");
    EXPECT_NE(refusal("zero.csv").find("it is a device, not a file"), std::string::npos);
    ASSERT_EQ(mkfifo((folder / "pipe.csv").c_str(), 0600), 0);
    EXPECT_NE(refusal("pipe.csv"), ""); // empty, and not waited for
}

TEST(PackingFile, OfThousandsOfOtherColumnsAFewAreNamed) {
    std::string names = "x,y,z,r", values = "1,2,3,0.5";
    for (int k = 0; k < 3000; ++k) {
        names += ",c" + std::to_string(k), values += ",1";
    }
    const ImportedPacking packing = parse(names + "\n" + values + "\n");
    ASSERT_EQ(packing.warnings.size(), 1U);
    EXPECT_NE(packing.warnings[0].find("\"c11\" and 2988 more ignored"), std::string::npos) << packing.warnings[0];
}

TEST(PackingFile, CsvMayCarryVelocitiesAndSpins) {
    const ImportedPacking packing = parse("x,y,z,r,vx,vy,vz,wx,wy,wz\n1,2,3,0.5,4,5,6,7,8,9\n");
    EXPECT_EQ(packing.grains.velocity[0], (Vec3{4, 5, 6}));
    EXPECT_EQ(packing.grains.spin[0], (Vec3{7, 8, 9}));
    EXPECT_TRUE(packing.warnings.empty());
    EXPECT_EQ(parse("x,y,z,r,wz,wy,wx\n1,2,3,0.5,9,8,7\n").grains.spin[0], (Vec3{7, 8, 9}));
}

TEST(PackingFile, BadCsvIsRefusedWithPlaceFoundAndExpected) {
    EXPECT_EQ(
        complaint("x,y,z\n1,2,3\n"), "p.csv:1: column r is missing; found \"x,y,z\", expected a header with x,y,z,r"
    );
    EXPECT_NE(complaint("x,y,z,r,vx,vz\n1,2,3,1,0,0\n").find("p.csv:1: column vy is missing"), std::string::npos);
    EXPECT_EQ(complaint("x,y,z,r,x\n"), "p.csv:1: column x occurs twice");
    EXPECT_EQ(complaint("x,y,z,r\n1,2,3,1\n1,nan,3,1\n"), "p.csv:3: column y: found \"nan\", expected a finite number");
    EXPECT_EQ(complaint("x,y,z,r\n1,2,3,inf\n"), "p.csv:2: column r: found \"inf\", expected a finite number");
    EXPECT_EQ(complaint("x,y,z,r\n1,2,3,0.5 mm\n"), "p.csv:2: column r: found \"0.5 mm\", expected a finite number");
    EXPECT_NE(
        complaint("x;y;z;r\n0,5;1;2;3\n").find("\"0,5\", expected a finite number with a decimal"), std::string::npos
    );
    EXPECT_NE(complaint("# vtk DataFile Version 3.0\nspheres\nASCII\n").find("has no points"), std::string::npos);
    EXPECT_EQ(complaint("x,y,z,r\n1,,3,1\n"), "p.csv:2: column y: found \"\", expected a finite number");
    EXPECT_EQ(complaint("x,y,z,r\n1,2,3,-0.5\n"), "p.csv:2: found radius -0.5, expected a positive one");
    EXPECT_EQ(complaint("x,y,z,r\n1,2,3,0\n"), "p.csv:2: found radius 0, expected a positive one");
    EXPECT_EQ(complaint("x,y,z,r\n1,2,3\n"), "p.csv:2: found 3 fields, expected 4");
    EXPECT_EQ(complaint("x,y,z,r\n"), "p.csv: no grains found, expected at least one");
    EXPECT_NE(complaint("").find("no grains found"), std::string::npos);
    EXPECT_NE(complaint("hello world\n").find("p.csv:1: found 2 fields, expected x y z r"), std::string::npos);
    EXPECT_NE(complaint("x,y,z,r\n1,2,\0003,4\n"s).find("column z: found \"?3\""), std::string::npos);
}

TEST(PackingFile, FileThatIsNotThereIsAnIoError) {
    const TempFolder folder;
    EXPECT_THROW(read_packing(folder / "none.csv", 2600), IoError);
    EXPECT_THROW(read_packing(folder.path(), 2600), IoError); // a folder is no file
}

TEST(PackingFile, LengthsMayBeInAnotherUnit) {
    const TempFolder folder;
    write_file(
        folder / "p.xyz", "1\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=pos:R:3:radius:R:1:velo:R:3\n1 2 3 0.5 1 0 0\n"
    );
    const ImportedPacking mm = read_packing(folder / "p.xyz", 2600, 1e-3);
    EXPECT_EQ(mm.grains.position[0].z, 3e-3);
    EXPECT_EQ(mm.grains.velocity[0].x, 1e-3);
    EXPECT_EQ(mm.grains.radius[0], 0.5e-3);
    EXPECT_NEAR(mm.grains.mass[0] / (2600 * sphere_volume(0.5e-3)), 1, 1e-12);               // rounding
    EXPECT_NEAR(mm.grains.inertia[0] / sphere_inertia(mm.grains.mass[0], 0.5e-3), 1, 1e-12); // rounding
    EXPECT_EQ(mm.cell->h(2, 2), 4e-3);
}

TEST(PackingFile, YadeTextNeedsNoHeader) {
    const ImportedPacking packing = parse("#format x_y_z_r\n1 2 3 0.5\n4\t5 6  0.25\n");
    ASSERT_EQ(packing.grains.size(), 2U);
    EXPECT_EQ(packing.grains.position[1], (Vec3{4, 5, 6}));
    EXPECT_EQ(packing.grains.radius[1], 0.25);
    EXPECT_NE(
        parse("1 2 3 0.5 7\n").warnings.at(0).find("behind x y z r are ignored"), std::string::npos
    ); // a material
    EXPECT_EQ(complaint("1 2 3 0.5\n1 2 3\n"), "p.csv:2: found 3 fields, expected 4");
}

TEST(PackingFile, NamesOfColumnsMayBeWrittenAsOtherProgramsDo) {
    for (const char* text :
         {"X,Y,Z,Radius\r\n1,2,3,0.5\r\n", "x [m];y [m];z [m];diameter [m]\n1;2;3;1\n", "x\ty\tz\tr \n1\t2\t3\t0.5 \n",
          "x [m]\ty [m]\tz [m]\tR [m]\n1\t2\t3\t0.5\n", "x y z r\n1 2 3 0.5\n", "\"x\",\"y\",\"z\",\"d\"\n1,2,3,1\n",
          "# r x y z\n0.5 1 2 3\n", "#format r_x_y_z\r\n0.5\t1\t2\t3\r\n"}) {
        const ImportedPacking packing = parse(text);
        ASSERT_EQ(packing.grains.size(), 1U) << text;
        EXPECT_EQ(packing.grains.position[0], (Vec3{1, 2, 3})) << text;
        EXPECT_EQ(packing.grains.radius[0], 0.5) << text;
        EXPECT_TRUE(packing.warnings.empty()) << text;
    }
    const ImportedPacking both = parse("id,x,y,z,radius,d\n7,1,2,3,0.5,2650\n"); // d may be anything, here a density
    EXPECT_EQ(both.grains.radius[0], 0.5);
    ASSERT_EQ(both.warnings.size(), 1U);
    EXPECT_NE(both.warnings[0].find("columns \"id\", \"d\" ignored"), std::string::npos) << both.warnings[0];
    EXPECT_EQ(complaint("x,y,z,d\n1,2,3,-1\n"), "p.csv:2: found diameter -1, expected a positive one");
    EXPECT_EQ(complaint("x,y,z,r,radius\n"), "p.csv:1: column r occurs twice");
}

TEST(PackingFile, YadeStatesItsColumnsAndItsCellInComments) {
    const ImportedPacking packing = parse("#format id_x_y_z_r_matId\n# by me\n17\t1\t2\t3\t0.5\t0\n");
    EXPECT_EQ(packing.grains.position[0], (Vec3{1, 2, 3}));
    EXPECT_EQ(packing.grains.radius[0], 0.5);
    EXPECT_EQ(parse("# by me\n\n  #format r_x_y_z\n0.5\t1\t2\t3\n").grains.radius[0], 0.5); // blank lines are no rows
    EXPECT_EQ(parse("#format x_y_z_r_attrs\n1\t2\t3\t0.5\t8\t9\n").grains.radius[0], 0.5);  // attrs are many columns
    EXPECT_EQ(parse("# centers x y z, radius r\n1 2 3 0.5\n").grains.position[0], (Vec3{1, 2, 3}));
    const ImportedPacking periodic = parse("##PERIODIC:: 4 5 6\n1 2 3 0.5 -1\n");
    ASSERT_TRUE(periodic.cell.has_value());
    EXPECT_EQ(periodic.cell->h, diagonal({4, 5, 6}));
    EXPECT_EQ(complaint("##PERIODIC:: 4 5\n"), "p.csv: found \"#PERIODIC:: 4 5\", expected three edges above 0");
    EXPECT_NE(complaint("##PERIODIC:: 4 -5 6\n").find("expected three edges above 0"), std::string::npos);
}

const char* const lammps_text =
    "LAMMPS data file\n\n2 atoms\n1 atom types\n0.5 4.5 xlo xhi\n0 5 ylo yhi\n0 6 zlo zhi\n"
    "0.5 0.25 0 xy xz yz\n\nMasses\n\n1 1.0\n\nAtoms # sphere\n\n"
    "7 1 1.0 2600 1 2 3\n3 1 0.5 2600 4 5 6\n\nVelocities\n\n3 1 2 3 4 5 6\n7 0 0 0 0 0 0\n";

TEST(PackingFile, LammpsDataBringsTheCellAndVelocitiesByAtom) {
    const ImportedPacking packing = parse(lammps_text);
    ASSERT_EQ(packing.grains.size(), 2U);
    EXPECT_EQ(packing.grains.radius[1], 0.25);                // diameters in the file
    EXPECT_EQ(packing.grains.position[1], (Vec3{3.5, 5, 6})); // relative to the corner of the box
    EXPECT_EQ(packing.grains.velocity[1], (Vec3{1, 2, 3}));   // atom 3 is the second row
    EXPECT_EQ(packing.grains.spin[1], (Vec3{4, 5, 6}));
    ASSERT_TRUE(packing.cell.has_value());
    EXPECT_EQ(packing.cell->h, from_columns({4, 0, 0}, {0.5, 5, 0}, {0.25, 0, 6}));
    ASSERT_EQ(packing.warnings.size(), 1U); // section Masses
}

TEST(PackingFile, BadLammpsDataIsRefused) {
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = lammps_text;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_NE(complaint(with("# sphere", "# atomic")).find("p.csv:14: found atom style \"atomic\""), std::string::npos);
    EXPECT_NE(complaint(with("2 atoms", "3 atoms")).find("found 2 atoms at the end"), std::string::npos);
    EXPECT_NE(complaint(with("7 1 1.0 2600 1 2 3", "7 1 1.0")).find("p.csv:16: found 3 fields"), std::string::npos);
    EXPECT_NE(complaint(with("7 1 1.0", "3 1 1.0")).find("atom id 3 occurs twice"), std::string::npos);
    EXPECT_NE(complaint(with("3 1 2 3 4", "9 1 2 3 4")).find("velocity of atom 9"), std::string::npos);
    EXPECT_NE(complaint(with("0 5 ylo", "5 5 ylo")).find("p.csv:6: found a box from 5 to 5"), std::string::npos);
    EXPECT_NE(complaint(with("7 1 1.0", "7 1 -1")).find("found diameter -1"), std::string::npos);
    EXPECT_NE(
        complaint(with("7 1 1.0 2600", "7 1 1.0 0.0")).find("found density 0"), std::string::npos
    );                                                                          // another style
    EXPECT_EQ(parse(with("7 1 1.0 2600", "7 1 1.0 1000")).warnings.size(), 2U); // another density than the case's
}

TEST(PackingFile, ReferencePackingIsReadFromGzip) {
    const ImportedPacking packing = read_packing(test::in_checkout("tests/reference/packing500.csv.gz"), 2600);
    ASSERT_EQ(packing.grains.size(), 500U);
    EXPECT_EQ(packing.grains.position[0].x, 0.00053771875529922612); // first number of the file
    const cell::Cell cell{diagonal({0.0014360856339985508, 0.0014358137235332051, 0.001436026846625529}), {}};
    const double solid = grains::solid_volume(packing.grains) / cell::volume(cell);
    EXPECT_NEAR(1 - solid, 0.4026691676584173, 1e-12); // porosity stated next to it; rounding
    const double worst = check_overlaps(packing.grains, cell, 0.1);
    // Settled at 100 kPa: the mean overlap is about p/E = 3e-4, the worst of 800 contacts some tens of times that.
    EXPECT_GT(worst, 3e-4);
    EXPECT_LT(worst, 0.03);
}

double any_number(std::uint64_t bits) {
    const auto value = std::bit_cast<double>(bits);
    return std::isfinite(value) ? value : static_cast<double>(bits);
}

RC_GTEST_PROP(PackingFile, WhatIsExportedComesBackToTheBit, ()) {
    const auto rows = *rc::gen::inRange(1, 8);
    grains::Grains grains;
    const auto number = [] { return any_number(*rc::gen::arbitrary<std::uint64_t>()); };
    const auto vector = [&] { return Vec3{number(), number(), number()}; };
    for (int k = 0; k < rows; ++k) {
        const double radius = std::abs(number());
        RC_PRE(radius > 0);
        const auto g = grains::add_grain(grains, vector(), radius, 2600);
        grains.velocity[g] = vector(), grains.spin[g] = vector();
    }
    const TempFolder folder;
    export_csv(folder / "p.csv", grains);
    const grains::Grains csv = read_packing(folder / "p.csv", 2600).grains;
    RC_ASSERT(csv.position == grains.position && csv.radius == grains.radius);
    RC_ASSERT(csv.velocity == grains.velocity && csv.spin == grains.spin);
    export_yade(folder / "p.txt", grains);
    const grains::Grains yade = read_packing(folder / "p.txt", 2600).grains;
    RC_ASSERT(yade.position == grains.position && yade.radius == grains.radius);
}

/// A good packing file with a few pieces put in or taken out anywhere.
std::string damaged_file() {
    auto text =
        *rc::gen::element<std::string>("x,y,z,r\n1,2,3,0.5\n4,5,6,0.5\n", "1 2 3 0.5\n4 5 6 0.5\n", lammps_text);
    const int damages = *rc::gen::inRange(0, 4);
    for (int k = 0; k < damages; ++k) {
        const auto piece = *rc::gen::element<std::string>(
            "", "", "x", ",", " ", "\n", "1", "-2", "nan", "1e999", "#", "atoms", "Atoms", "xlo xhi", "xy xz yz",
            "Masses", "Velocities", "\r\n", std::string(1, '\0'), "\xEF\xBB\xBF", "\x1f\x8b", "99999999999999999999"
        );
        const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size()) + 1));
        text.replace(at, static_cast<std::size_t>(*rc::gen::inRange(0, 5)), piece);
    }
    return text;
}

RC_GTEST_PROP(PackingFile, DamagedFilesAreEitherAPackingOrAnErrorOfOurs, ()) {
    const std::string text = damaged_file();
    try {
        const ImportedPacking packing = parse(text);
        for (std::size_t g = 0; g < packing.grains.size(); ++g) {
            RC_ASSERT(std::isfinite(norm(packing.grains.position[g])) && packing.grains.radius[g] > 0);
        }
        RC_TAG("read");
    } catch (const Error&) {
        RC_TAG("refused");
    }
}

TEST(PackingFile, GzipThatWasCutIsAnIoError) {
    const TempFolder folder;
    const std::string whole = test::read_all(test::in_checkout("tests/reference/packing500.csv.gz"));
    write_file(folder / "cut.csv.gz", whole.substr(0, whole.size() / 2));
    EXPECT_THROW(read_packing(folder / "cut.csv.gz", 2600), IoError);
}

TEST(PackingExport, ExtendedXyzHasTheCellAndAllColumns) {
    grains::Grains grains;
    grains::add_grain(grains, {1.25, -0.25, 0.5}, 0.125, 2600);
    const TempFolder folder;
    cell::Cell cell;
    cell.h(0, 1) = 0.5;
    export_extended_xyz(folder / "p.xyz", grains, cell);
    EXPECT_EQ(
        test::read_all(folder / "p.xyz"),
        "1\nLattice=\"1 0 0 0.5 1 0 0 0 1\" Properties=species:S:1:pos:R:3:radius:R:1:velo:R:3:"
        "angular_velocity:R:3:id:I:1:fine:I:1 pbc=\"T T T\"\ncoarse 0.75 0.75 0.5 0.125 0 0 0 0 0 0 0 0\n"
    );
    export_extended_xyz(folder / "p.xyz", grains, cell, {{"color", 3, {1, 0.5, 0}}, {"mean_stress", 1, {2}}});
    const std::string more = test::read_all(folder / "p.xyz");
    EXPECT_NE(more.find("fine:I:1:color:R:3:mean_stress:R:1 pbc"), std::string::npos) << more;
    EXPECT_TRUE(more.ends_with("0 0 1 0.5 0 2\n")) << more;
    EXPECT_THROW(export_extended_xyz(folder / "p.xyz", grains, cell, {{"short", 3, {1}}}), Bug);
}

} // namespace
} // namespace suffuse::io
