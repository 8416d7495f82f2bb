#include "suffuse/io/contact_table.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/step.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/packing_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/packings.hpp"
#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/worlds.hpp"
#include <string>

namespace suffuse::io {
namespace {

using test::TempFolder;

grains::Grains three_grains() {
    grains::Grains grains;
    for (int k = 0; k < 3; ++k) {
        grains::add_grain(grains, {1e-3 * k, 0, 0}, 0.6e-3, 2600);
    }
    return grains;
}

std::string complaint(const std::string& text) {
    const TempFolder folder;
    write_file(folder / "c.any", text);
    try {
        read_contacts(folder / "c.any", three_grains());
    } catch (const CaseError& error) {
        const std::string message = error.what();
        return message.substr(message.find("c.any")); // without the folder
    }
    return "";
}

const std::string header = "first,second,shear_x,shear_y,shear_z,moment_x,moment_y,moment_z\n";

TEST(ContactTable, WhatIsWrittenIsReadBackToTheBit) {
    dem::World world = test::reference_packing("packing500");
    dem::StepCaches caches;
    dem::StepPlan plan = test::plan_of(dem::stable_time_step(world), 0.2);
    plan.loading.velocity_gradient = diagonal({20, 20, -50}); // [1/s]
    test::advance(world, caches, plan, 50);
    const TempFolder folder;
    export_contacts(folder / "contacts.csv", world);
    const std::vector<dem::GivenContact> read = read_contacts(folder / "contacts.csv", world.grains);
    const std::vector<dem::ContactView> own = dem::inspect_contacts(world);
    ASSERT_EQ(read.size(), own.size());
    double moved = 0;
    for (std::size_t c = 0; c < own.size(); ++c) {
        EXPECT_EQ(read[c].first, own[c].i);
        EXPECT_EQ(read[c].second, own[c].j);
        EXPECT_EQ(read[c].shear_force, own[c].shear_force);
        EXPECT_EQ(read[c].moment, own[c].moment);
        moved += norm(own[c].moment);
    }
    EXPECT_GT(moved, 0);
}

// Two grains of 0.5 and 0.3 mm that slide and roll in LAMMPS of 29 Sep 2021 (tests/packings/README.md), and the forces
// and torques on them that it wrote next to it.
TEST(ContactTable, ADumpOfLammpsGivesTheForcesAndTorquesThatLammpsHad) {
    const auto grains = read_packing(test::in_checkout("tests/packings/lammps-two.dump"), 2600).grains;
    const auto contacts = read_contacts(test::in_checkout("tests/packings/lammps-two-contacts.dump"), grains);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].first, 0U);
    EXPECT_EQ(contacts[0].second, 1U);
    const Vec3 branch = grains.position[1] - grains.position[0], n = branch / norm(branch);
    const double overlap = 0.8e-3 - norm(branch), stiffness = 1e4; // of that input [N/m]
    const Vec3 force = contacts[0].shear_force - stiffness * overlap * n;
    EXPECT_LT(norm(force - Vec3{-0.031674298965532859, -0.00054353585825435652, 0.0009309617918631805}), 1e-14);
    // LAMMPS lets the shear force act half the overlap below the surface
    const Vec3 torque = contacts[0].moment + (0.5e-3 - 0.5 * overlap) * cross(n, contacts[0].shear_force);
    EXPECT_LT(norm(torque - Vec3{2.4695840230651771e-09, -2.6944081531811021e-07, -7.2926703545550691e-08}), 1e-19);
}

TEST(ContactTable, NearNeighborsOfADumpThatDoNotTouchAreNoContacts) {
    const std::string head = "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
                             "ITEM: ENTRIES index a b c d e f g h i j k\n";
    const TempFolder folder;
    write_file(folder / "c.dump", head + "1 1 2 0 1 0 0 0 0 -1e-3 0 0\n2 2 3 0 0 0 0 0 0 -2e-3 0 0\n");
    EXPECT_EQ(read_contacts(folder / "c.dump", three_grains()).size(), 1U);
}

TEST(ContactTable, ATableThatCannotBeMeantIsRefusedWithItsLine) {
    EXPECT_NE(complaint("").find("the file is empty, expected a table of contacts"), std::string::npos);
    EXPECT_NE(
        complaint("i,j\n0,1\n").find("c.any:1: found \"i,j\", expected the header first,second"), std::string::npos
    );
    EXPECT_EQ(complaint(header + "0,1,0,0,0,0,0\n"), "c.any:2: found 7 fields, expected 8");
    EXPECT_EQ(
        complaint(header + "0,3,0,0,0,0,0,0\n"), "c.any:2: found grain 3, expected 0 to 2: the packing has 3 grains"
    );
    EXPECT_NE(complaint(header + "1,1,0,0,0,0,0,0\n").find("in contact with itself"), std::string::npos);
    EXPECT_NE(complaint(header + "0,1,0,x,0,0,0,0\n").find("c.any:2:"), std::string::npos);
    EXPECT_NE(complaint("ITEM: TIMESTEP\n7\n").find("found no section ITEM: ENTRIES"), std::string::npos);
    EXPECT_NE(complaint("ITEM: ENTRIES index a b\n1 1 2\n").find("found 2 columns, expected 11"), std::string::npos);
    EXPECT_NE(
        complaint("ITEM: NUMBER OF ENTRIES\n2\nITEM: ENTRIES a b c d e f g h i j k\n1 2 0 0 0 0 0 0 1 0 0\n")
            .find("the file ends, expected 2 contacts, found 1"),
        std::string::npos
    );
    EXPECT_NE(
        complaint("ITEM: NUMBER OF ENTRIES\n1\nITEM: ENTRIES a b c d e f g h i j k\n0 2 0 0 0 0 0 0 1 0 0\n")
            .find("found grain 0, expected 1 to 3"),
        std::string::npos
    );
}

} // namespace
} // namespace suffuse::io
