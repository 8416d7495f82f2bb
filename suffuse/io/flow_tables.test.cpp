#include "suffuse/io/flow_tables.hpp"

#include "suffuse/base/error.hpp"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <cstring>

namespace suffuse::io {
namespace {

using test::read_all;
using test::TempFolder;

/// One pore that meets its own image through one throat: enough for the tables, no triangulation.
pores::PoreNetwork one_pore() {
    pores::PoreNetwork network;
    network.h = diagonal({2, 2, 2});
    network.pores.grain = {{0, 1, 2, 3}};
    network.pores.grain_image = {{}};
    network.pores.grain_image[0][3] = cell::Image{0, 0, 1};
    network.pores.center = {{0.25, 0.5, 0.75}};
    network.pores.volume = {0.5};
    network.pores.void_volume = {0.125};
    network.throats.side = {{0, 0}};
    network.throats.void_area = {2};
    network.throats.hydraulic_radius = {3};
    network.throats.inscribed_radius = {4};
    network.throats.length = {5};
    return network;
}

TEST(FlowTables, PoresAndThroatsHaveTheColumnsOfTheFormat) {
    const TempFolder folder;
    const std::vector<double> pressure{7}, conductance{8}, flux{-9};
    const std::vector<Vec3> velocity{{-1, 2, 0}};
    write_pores_csv(folder / "pores.csv", one_pore(), pressure, velocity);
    EXPECT_EQ(
        read_all(folder / "pores.csv"), "x,y,z,volume,void_volume,pressure,vx,vy,vz\n0.25,0.5,0.75,0.5,0.125,7,-1,2,0\n"
    );
    write_throats_csv(folder / "throats.csv", one_pore(), conductance, flux);
    EXPECT_EQ(
        read_all(folder / "throats.csv"),
        "pore_1,pore_2,area,hydraulic_radius,inscribed_radius,length,conductance,flux\n0,0,2,3,4,5,8,-9\n"
    );
    EXPECT_THROW(write_pores_csv(folder / "pores.csv", one_pore(), {}, velocity), Bug);
    EXPECT_THROW(write_pores_csv(folder / "pores.csv", one_pore(), pressure, {}), Bug);
    EXPECT_THROW(write_throats_csv(folder / "throats.csv", one_pore(), conductance, {}), Bug);
}

TEST(FlowTables, CornersOfAPoreAreTheImagesThatItTouches) {
    const TempFolder folder;
    const std::vector<Vec3> position{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    const std::vector<double> pressure{7};
    const std::vector<Vec3> velocity{{-1, 2, 3}};
    write_pores_vtu(folder / "pores.vtu", one_pore(), position, pressure, velocity);
    const std::string text = read_all(folder / "pores.vtu");
    const auto holds = [&](const std::vector<float>& values) {
        const auto* bytes = reinterpret_cast<const char*>(values.data());
        return text.find({bytes, values.size() * sizeof(float)}) != std::string::npos;
    };
    EXPECT_TRUE(holds({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})); // the last one a period higher
    EXPECT_TRUE(holds({-1, 2, 3}));
}

} // namespace
} // namespace suffuse::io
