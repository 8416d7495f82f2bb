#include "suffuse/run/strain_pictures.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include "tests/support/worlds.hpp"

namespace suffuse::run {
namespace {

/// The world with its cell shortened along z to this strain, -ln(L/L0).
dem::World strained(dem::World world, double strain) {
    world.cell.h = world.reference_h;
    world.cell.h(2, 2) *= std::exp(-strain);
    return world;
}

dem::World a_world() {
    dem::World world = test::empty_world(1e-3);
    test::add(world, {5e-4, 5e-4, 5e-4}, 1e-4);
    world.reference_h = world.cell.h;
    return world;
}

TEST(StrainPictures, AreWrittenAtEachMultipleOfTheSpecifiedStrain) {
    const test::TempFolder folder;
    casefile::OutputSpec output;
    output.formats = {"vtp", "xyz"};
    output.snapshots = {casefile::Snapshots::When::Strain, 0.01};
    const dem::World world = a_world();
    StrainPictures pictures(output, folder.path(), world);
    for (const double strain : {0.004, 0.009, 0.0101, 0.012, 0.0205, 0.019}) {
        pictures.see(strained(world, strain));
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "strain-0001.vtp"));
    EXPECT_TRUE(std::filesystem::exists(folder / "strain-0002.xyz"));
    EXPECT_EQ(folder.entries(), 4);
    pictures.finish();
    const std::string series = test::read_all(folder / "strain-series.pvd");
    EXPECT_NE(series.find("timestep=\"0.02\" part=\"0\" file=\"strain-0002.vtp\""), std::string::npos) << series;

    StrainPictures resumed(output, folder.path(), strained(world, 0.0205)); // goes on with the next name
    resumed.see(strained(world, 0.025));
    EXPECT_FALSE(std::filesystem::exists(folder / "strain-0003.vtp"));
    resumed.see(strained(world, 0.031));
    EXPECT_TRUE(std::filesystem::exists(folder / "strain-0003.vtp"));
    resumed.begin_anew(world);
    EXPECT_FALSE(std::filesystem::exists(folder / "strain-0001.vtp"));
}

TEST(StrainPictures, AreNoneUnlessRequested) {
    const test::TempFolder folder;
    const casefile::OutputSpec output;
    const dem::World world = a_world();
    StrainPictures pictures(output, folder.path(), world);
    pictures.see(strained(world, 0.5));
    pictures.finish();
    EXPECT_EQ(folder.entries(), 0);
}

} // namespace
} // namespace suffuse::run
