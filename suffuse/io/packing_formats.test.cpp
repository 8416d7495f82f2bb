#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/packing_file.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace suffuse::io {
namespace {

using test::TempFolder;

ImportedPacking parse(const std::string& text, const std::string& name = "p.any") {
    const TempFolder folder;
    write_file(folder / name, text);
    return read_packing(folder / name, 2600);
}

std::string complaint(const std::string& text) {
    try {
        parse(text);
    } catch (const CaseError& error) {
        const std::string message = error.what();
        return message.substr(message.find("p.any")); // without the folder
    }
    return "";
}

/// Finite, and far from overflow when a corner is taken off.
double any_number() {
    const auto value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    return std::isfinite(value) && std::abs(value) < 1e150 ? value : 1.5;
}

dem::World any_world(bool tilted) {
    dem::World world;
    world.cell.h = diagonal({0.1 + std::abs(*rc::gen::arbitrary<std::int16_t>()), 1.1, 1.3});
    if (tilted) {
        world.cell.h(0, 1) = 0.5, world.cell.h(0, 2) = -0.25, world.cell.h(1, 2) = 0.125;
    }
    const auto vector = [] { return Vec3{any_number(), any_number(), any_number()}; };
    const auto rows = *rc::gen::inRange(1, 8);
    for (int k = 0; k < rows; ++k) {
        // Neither volume nor mass over- or underflows.
        const double radius = std::clamp(std::abs(any_number()), 1e-80, 1e80);
        const auto g = grains::add_grain(world.grains, vector(), radius, 2600);
        world.grains.velocity[g] = vector(), world.grains.spin[g] = vector();
        world.grains.fine[g] = static_cast<std::uint8_t>(k % 2);
    }
    return world;
}

void same_grains(const grains::Grains& a, const grains::Grains& b) {
    RC_ASSERT(a.position == b.position && a.radius == b.radius);
    RC_ASSERT(a.velocity == b.velocity && a.spin == b.spin);
}

RC_GTEST_PROP(PackingFormats, LammpsAndVtpCarryGrainsAndCellToTheBit, (bool tilted)) {
    const dem::World world = any_world(tilted);
    const TempFolder folder;
    for (const auto& [file, format] : {std::pair{"p.data", PackingFormat::LammpsData}, {"p.vtp", PackingFormat::Vtp}}) {
        export_packing(folder / file, world, format);
        const ImportedPacking back = read_packing(folder / file, 2600);
        same_grains(back.grains, world.grains);
        RC_ASSERT(back.cell.has_value() && back.cell->h == world.cell.h);
    }
    RC_ASSERT(read_packing(folder / "p.vtp", 2600).grains.fine == world.grains.fine);
}

RC_GTEST_PROP(PackingFormats, ADumpCarriesGrainsToTheBitAndABoxCellToo, (bool tilted)) {
    const dem::World world = any_world(tilted);
    const TempFolder folder;
    export_packing(folder / "p.dump", world, PackingFormat::LammpsDump);
    const ImportedPacking back = read_packing(folder / "p.dump", 2600);
    for (std::size_t g = 0; g < world.grains.size(); ++g) { // the bounds of a tilted box are sums: rounding
        RC_ASSERT(norm(back.grains.position[g] - world.grains.position[g]) <= (tilted ? 1e-15 : 0.0));
    }
    RC_ASSERT(back.grains.radius == world.grains.radius && back.grains.velocity == world.grains.velocity);
    for (int a = 0; a < 3; ++a) {
        RC_ASSERT(std::abs(back.cell->h(a, a) - world.cell.h(a, a)) <= (tilted ? 1e-15 * world.cell.h(a, a) : 0.0));
        RC_ASSERT(back.cell->h(0, a) == world.cell.h(0, a) || a == 0);
    }
}

TEST(PackingFormats, ExtendedXyzCarriesTheCellAndGrainsAtHomeToTheBit) {
    dem::World world;
    world.cell.h = from_columns({1.25, 0.0, 0.1}, {0.5, 1.5, 0}, {0, 0.25, 2});
    for (int k = 0; k < 5; ++k) { // inside the cell, where the format brings every grain
        const double s = 0.1 + 0.15 * k;
        const auto g = grains::add_grain(world.grains, world.cell.h * Vec3{s, 0.7 * s, 1 - s}, 0.01 + 0.3 * s, 2600);
        world.grains.velocity[g] = {1.0 / 3, s, -s};
        world.grains.spin[g] = {s, 1e-300, -7};
        world.grains.fine[g] = static_cast<std::uint8_t>(k % 2);
    }
    const TempFolder folder;
    export_packing(folder / "p.xyz", world, PackingFormat::ExtendedXyz);
    const ImportedPacking back = read_packing(folder / "p.xyz", 2600);
    EXPECT_EQ(back.grains.position, world.grains.position);
    EXPECT_EQ(back.grains.radius, world.grains.radius);
    EXPECT_EQ(back.grains.velocity, world.grains.velocity);
    EXPECT_EQ(back.grains.spin, world.grains.spin);
    EXPECT_EQ(back.grains.fine, world.grains.fine);
    ASSERT_TRUE(back.cell.has_value());
    EXPECT_EQ(back.cell->h, world.cell.h);
}

TEST(PackingFormats, AGrainBroughtHomeMovesAsTheMeanMotionDoesThere) {
    dem::World world;
    world.cell.h = from_columns({2, 0, 0}, {0.5, 3, 0}, {0, 0, 4});
    world.cell.velocity_gradient(0, 2) = 0.5, world.cell.velocity_gradient(1, 1) = -0.25;
    const Vec3 place{0.25, 0.5, 1}, motion{1, 2, 3};
    for (const cell::Image image : {cell::Image(0, 0, 0), cell::Image(1, -2, 3)}) { // one grain and its image
        const Vec3 shift = cell::shift(world.cell.h, image);
        const auto g = grains::add_grain(world.grains, place + shift, 0.1, 2600);
        world.grains.velocity[g] = motion + world.cell.velocity_gradient * shift;
    }
    const TempFolder folder;
    export_packing(folder / "p.xyz", world, PackingFormat::ExtendedXyz);
    const ImportedPacking back = read_packing(folder / "p.xyz", 2600);
    EXPECT_EQ(back.grains.position, (std::vector<Vec3>{place, place}));
    EXPECT_EQ(back.grains.velocity, (std::vector<Vec3>{motion, motion}));
}

TEST(PackingFormats, LammpsGetsACellThatItCannotHoldTurnedWithItsGrains) {
    dem::World world; // as released shear stresses leave it
    world.cell.h = from_columns({1.25, 0.02, -0.1}, {0.05, 1.5, 0.03}, {-0.1, 0.03, 2});
    for (int k = 0; k < 3; ++k) {
        const double s = 0.1 + 0.25 * k;
        const auto g = grains::add_grain(world.grains, {s, 0.7 * s, 1 - s}, 0.1, 2600);
        world.grains.velocity[g] = {1, s, -s};
        world.grains.spin[g] = {s, 2, -7};
    }
    const TempFolder folder;
    for (const auto& [file, format] :
         {std::pair{"p.data", PackingFormat::LammpsData}, {"p.dump", PackingFormat::LammpsDump}}) {
        export_packing(folder / file, world, format);
        const ImportedPacking back = read_packing(folder / file, 2600);
        ASSERT_TRUE(back.cell.has_value());
        const Mat3 turn = back.cell->h * inverse(world.cell.h);
        const auto none = [](const Mat3& m) { return norm(m.column(0)) + norm(m.column(1)) + norm(m.column(2)); };
        EXPECT_LE(none(transpose(turn) * turn - identity()), 1e-14) << file; // rounding
        EXPECT_GT(determinant(turn), 0);
        for (std::size_t g = 0; g < world.grains.size(); ++g) {
            EXPECT_LE(norm(back.grains.position[g] - turn * world.grains.position[g]), 1e-14) << file;
            EXPECT_LE(norm(back.grains.velocity[g] - turn * world.grains.velocity[g]), 1e-14) << file;
            EXPECT_LE(norm(back.grains.spin[g] - turn * world.grains.spin[g]), 1e-14) << file;
        }
    }
    EXPECT_NO_THROW(export_packing(folder / "p.vtp", world, PackingFormat::Vtp));
}

TEST(PackingFormats, AFileEndingDeterminesTheFormatAndEachNameHasOne) {
    EXPECT_EQ(packing_format_of_file("a/b.lammpstrj"), PackingFormat::LammpsDump);
    EXPECT_EQ(packing_format_of_file("a.txt"), PackingFormat::Yade);
    EXPECT_EQ(packing_format_of_file("a.pdf"), std::nullopt);
    const std::string page = test::read_all(test::in_checkout("docs/formats.md"));
    for (const std::string& name : packing_format_names()) {
        EXPECT_TRUE(packing_format_of_name(name).has_value()) << name;
        EXPECT_NE(page.find("\n| `" + name + "` | "), std::string::npos) << name << " has no row in docs/formats.md";
    }
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

const char* const dump_text = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
                              "ITEM: ATOMS id x y z radius\n1 9 9 9 0.5\n"
                              "ITEM: TIMESTEP\n10\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp pp\n"
                              "-1 4.5 0.5\n0 2 -1\n-3 3 0\n"
                              "ITEM: ATOMS id type xs ys zs diameter\n1 1 0.5 0.25 0.75 0.5\n2 1 0 0 0 1\n";

TEST(PackingFormats, ADumpIsReadAtItsLastFrameWithScaledPositionsAndATiltedBox) {
    const ImportedPacking packing = parse(dump_text);
    ASSERT_EQ(packing.grains.size(), 2U);
    // LAMMPS's bounding box: xlo = -1 - min(0, xy, xz, xy+xz) = 0, xhi = 4.5 - max(0, xy, xz, xy+xz) = 4.
    EXPECT_EQ(packing.cell->h, from_columns({4, 0, 0}, {0.5, 2, 0}, {-1, 0, 6}));
    EXPECT_EQ(packing.grains.position[0], (Vec3{0.5 * 4 + 0.25 * 0.5 - 0.75, 0.5, 4.5}));
    EXPECT_EQ(packing.grains.radius[0], 0.25);
    ASSERT_EQ(packing.warnings.size(), 1U);
    EXPECT_NE(packing.warnings[0].find("the last of 2 frames"), std::string::npos);
}

TEST(PackingFormats, ABoxThatIsNotPeriodicIsNoCell) {
    const std::string dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\n"
                             "ITEM: ATOMS id x y z radius\n1 0.5 0.5 0.5 0.1\n";
    const ImportedPacking walls = parse(dump);
    EXPECT_FALSE(walls.cell.has_value());
    EXPECT_NE(walls.no_cell.find("p.any:5: found boundaries ff along z"), std::string::npos) << walls.no_cell;
    for (const char* sides : {"pp pp pp", "xy xz yz pp pp pp", ""}) { // old versions do not state it
        std::string text = replaced(dump, "pp pp ff", sides);
        if (sides[0] == 'x') {
            text = replaced(text, "0 1\n0 1\n0 1\n", "0 1 0\n0 1 0\n0 1 0\n");
        }
        EXPECT_TRUE(parse(text).cell.has_value()) << sides;
        EXPECT_TRUE(parse(text).no_cell.empty()) << sides;
    }
    const std::string xyz = "1\nLattice=\"1 0 0 0 1 0 0 0 1\" Properties=pos:R:3:radius:R:1 pbc=\"T F T\"\n0 0 0 0.1\n";
    EXPECT_NE(parse(xyz).no_cell.find("p.any:2: found pbc F along y"), std::string::npos);
    EXPECT_TRUE(parse(replaced(xyz, "T F T", "T T T")).cell.has_value());
}

TEST(PackingFormats, BadFilesAreRefusedWithTheirPlace) {
    EXPECT_NE(complaint("ITEM: TIMESTEP\n0\n").find("no section ITEM: ATOMS"), std::string::npos);
    EXPECT_NE(
        complaint("ITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y z\n1 0 0 0\n").find("p.any:3: found columns id x y z"),
        std::string::npos
    );
    EXPECT_NE(complaint("1\nProperties=pos:R:3\n0 0 0\n").find("p.any:2: Properties: expected"), std::string::npos);
    EXPECT_NE(
        complaint("2\nProperties=pos:R:3:radius:R:1\n0 0 0 1\n").find("ends after 1 particles, expected 2"),
        std::string::npos
    );
    EXPECT_NE(
        complaint("1\nLattice=\"1 0 0\" Properties=pos:R:3:radius:R:1\n0 0 0 1\n").find("Lattice: found 3 numbers"),
        std::string::npos
    );
    EXPECT_NE(complaint("<VTKFile type=\"PolyData\"></VTKFile>").find("has no points"), std::string::npos);
}

/// PolyData of two grains as other programs write it.
std::string vtp(const std::string& head, const std::string& radius, const std::string& points) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"" + head +
           "><PolyData><Piece NumberOfPoints=\"2\">\n<PointData Scalars=\"radius\">\n" + radius +
           "</PointData>\n<Points>\n" + points + "</Points></Piece></PolyData></VTKFile>\n";
}

TEST(PackingFormats, AVtpMayBeAsciiOrBase64) {
    const std::string points = "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n"
                               "1 2 3\n4 5 6\n</DataArray>\n";
    const ImportedPacking ascii =
        parse(vtp("", "<DataArray type=\"Float64\" Name=\"radius\" format=\"ascii\">0.5 0.25</DataArray>\n", points));
    EXPECT_EQ(ascii.grains.position[1], (Vec3{4, 5, 6}));
    EXPECT_EQ(ascii.grains.radius[1], 0.25);
    EXPECT_FALSE(ascii.cell.has_value());
    // Python: base64.b64encode(struct.pack("<I", 16)) + base64.b64encode(struct.pack("<2d", 0.5, 0.25)), and in one go.
    for (const std::string bytes : {"EAAAAA==AAAAAAAA4D8AAAAAAADQPw==", "EAAAAAAAAAAAAOA/AAAAAAAA0D8="}) {
        const ImportedPacking binary = parse(
            vtp(" header_type=\"UInt32\"",
                "<DataArray type=\"Float64\" Name=\"radius\" format=\"binary\">\n" + bytes + "\n</DataArray>\n", points)
        );
        EXPECT_EQ(binary.grains.radius, ascii.grains.radius) << bytes;
    }
}

TEST(PackingFormats, AVtpMayBeCompressed) {
    // Python: with c = zlib.compress(struct.pack("<2d", 0.5, 0.25)),
    // base64.b64encode(struct.pack("<4I", 1, 32768, 16, len(c))) + base64.b64encode(c).
    const auto compressed = [](const std::string& bytes) {
        return vtp(
            " header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"",
            "<DataArray type=\"Float64\" Name=\"radius\" format=\"binary\">" + bytes + "</DataArray>\n",
            "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3 4 5 6</DataArray>\n"
        );
    };
    EXPECT_EQ(
        parse(compressed("AQAAAACAAAAQAAAAEgAAAA==eJxjYACBB/ZgiuGCPQAM5gIv")).grains.radius,
        (std::vector<double>{0.5, 0.25})
    );
    EXPECT_NE(
        complaint(compressed("AQAAAACAAAAQAAAAEgAAAA==eJxjYACBB/Zg")).find("array radius: is cut short"),
        std::string::npos
    );
}

TEST(PackingFormats, AVtpMayHaveSingleQuotesAndItsNumbersAreWhole) {
    const std::string points =
        "<DataArray type='Float32' NumberOfComponents='3' format='ascii'>1 2 3 4 5 6</DataArray>";
    const auto radius = [](const std::string& values) {
        return "<DataArray type='Float64' Name='radius' format='ascii'>" + values + "</DataArray>\n";
    };
    EXPECT_EQ(parse(vtp("", radius("0.5 +0.25"), points)).grains.radius, (std::vector<double>{0.5, 0.25}));
    EXPECT_NE(complaint(vtp("", radius("0.5 0.25abc"), points)).find("found \"0.25abc\""), std::string::npos);
    EXPECT_NE(
        complaint(vtp("", radius("0.5 0.25"), replaced(points, "'3'", "'3x'"))).find("found \"3x\""), std::string::npos
    );
}

TEST(PackingFormats, ALengthThatCannotBeIsRefusedBeforeMemoryIsTaken) {
    // As above, but with blocks of 0xf0000000 bytes, 4 GB, in 18 packed ones.
    const std::string file =
        vtp(" header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\"",
            "<DataArray type=\"Float64\" Name=\"radius\" format=\"binary\">"
            "AQAAAAAAAPAAAAAAEgAAAA==eJxjYACBB/ZgiuGCPQAM5gIv</DataArray>\n",
            "<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">1 2 3 4 5 6</DataArray>\n");
    EXPECT_NE(complaint(file).find("array radius: cannot be decompressed"), std::string::npos);
    EXPECT_NE(complaint(replaced(file, "AQAAAA", "AQ!AAA")).find("not in base64"), std::string::npos);
}

RC_GTEST_PROP(PackingFormats, DamagedFilesAreEitherAPackingOrAnErrorOfOurs, ()) {
    dem::World world;
    world.cell.h = diagonal({1, 1, 1});
    grains::add_grain(world.grains, {0.5, 0.5, 0.5}, 0.1, 2600);
    const TempFolder folder;
    const auto format = *rc::gen::element(PackingFormat::Vtp, PackingFormat::ExtendedXyz, PackingFormat::LammpsDump);
    export_packing(folder / "p", world, format);
    std::string text = test::read_all(folder / "p");
    const int damages = *rc::gen::inRange(1, 6);
    for (int k = 0; k < damages; ++k) {
        const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size()) + 1));
        const auto piece = *rc::gen::element<std::string>("", "9", "<", ">", "\"", "nan", "\n", "\xff", "99999999999");
        text.replace(at, static_cast<std::size_t>(*rc::gen::inRange(0, 5)), piece);
    }
    try {
        const ImportedPacking packing = parse(text);
        for (std::size_t g = 0; g < packing.grains.size(); ++g) {
            RC_ASSERT(std::isfinite(norm(packing.grains.position[g])) && packing.grains.radius[g] > 0);
        }
    } catch (const Error&) {
        RC_TAG("refused");
    }
}

} // namespace
} // namespace suffuse::io
