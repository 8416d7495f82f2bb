#include "suffuse/io/tables.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/csv_writer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <bit>
#include <cmath>
#include <cstdlib>

namespace suffuse::io {
namespace {

using test::read_all;
using test::TempFolder;

TEST(CsvWriter, PrintsVectorsMatricesAndTextAsFields) {
    const TempFolder folder;
    CsvWriter table(folder / "a.csv", "id,x,y,z,name,flag");
    table.row(7, Vec3{0.1, 1e-9, -0.0}, "fine", true);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.csv"));
    table.finish();
    EXPECT_EQ(read_all(folder / "a.csv"), "id,x,y,z,name,flag\n7,0.1,1e-09,-0,fine,1\n");
    CsvWriter wrong(folder / "b.csv", "a,b");
    EXPECT_THROW(wrong.row(1), Bug);
}

RC_GTEST_PROP(CsvWriter, NumbersComeBackToTheBit, (std::uint64_t bits)) {
    const auto value = std::bit_cast<double>(bits);
    RC_PRE(std::isfinite(value));
    const TempFolder folder;
    CsvWriter table(folder / "a.csv", "v");
    table.row(value);
    table.finish();
    const double back = std::strtod(read_all(folder / "a.csv").c_str() + 2, nullptr);
    RC_ASSERT(std::bit_cast<std::uint64_t>(back) == bits);
}

/// Two touching grains and one apart, stored out of the order of their ids.
dem::World small_world() {
    dem::World world;
    world.cell.h = diagonal({4, 4, 4});
    grains::add_grain(world.grains, {1, 1, 1}, 0.5, 2600);
    grains::add_grain(world.grains, {3, 3, 3}, 0.25, 2600);
    grains::add_grain(world.grains, {1.75, 1, 1}, 0.5, 2600);
    world.grains.id = {5, 2, 9};
    world.grains.fine = {0, 1, 0};
    world.grains.velocity[1] = {1, 2, 3};
    world.contacts.first = {0, 0}, world.contacts.second = {1, 2};
    world.contacts.image.resize(2);
    for (contact::VectorColumn* column :
         {&world.contacts.shear_force, &world.contacts.bending, &world.contacts.normal}) {
        column->resize(2);
    }
    world.contacts.overlap = {0, 0.25};
    world.contacts.normal.set(1, {1, 0, 0});
    world.contacts.shear_force.set(1, {0, 2, 0});
    return world;
}

TEST(Tables, GrainsComeInOrderOfIdWithTheirContacts) {
    const TempFolder folder;
    write_grains_csv(folder / "grains.csv", small_world());
    EXPECT_EQ(
        read_all(folder / "grains.csv"), "id,x,y,z,r,vx,vy,vz,wx,wy,wz,fx,fy,fz,tx,ty,tz,contacts,fine\n"
                                         "2,3,3,3,0.25,1,2,3,0,0,0,0,0,0,0,0,0,0,1\n"
                                         "5,1,1,1,0.5,0,0,0,0,0,0,0,0,0,0,0,0,1,0\n"
                                         "9,1.75,1,1,0.5,0,0,0,0,0,0,0,0,0,0,0,0,1,0\n"
    );
}

TEST(Tables, ContactsNameGrainsByIdAndGiveTheForceOnTheFirst) {
    const TempFolder folder;
    const dem::World world = small_world();
    write_contacts_csv(folder / "contacts.csv", world);
    const std::string text = read_all(folder / "contacts.csv");
    // kn = E r for equal grains; the force on i points against n, the shear force on i is minus the stored one.
    EXPECT_EQ(
        text, "i,j,overlap,nx,ny,nz,fnx,fny,fnz,fsx,fsy,fsz,mx,my,mz\n" +
                  fmt::format("5,9,0.25,1,0,0,{},-0,-0,-0,-2,-0,-0,-0,-0\n", -world.material.modulus * 0.5 * 0.25)
    );
}

TEST(Tables, FluidForcesComeInOrderOfId) {
    const TempFolder folder;
    const grains::GrainLoad load{{{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}};
    write_grain_forces_csv(folder / "f.csv", small_world().grains, load);
    EXPECT_EQ(read_all(folder / "f.csv"), "id,fx,fy,fz\n2,2,0,0\n5,1,0,0\n9,3,0,0\n");
    EXPECT_THROW(write_grain_forces_csv(folder / "f.csv", small_world().grains, {}), Bug);
}

} // namespace
} // namespace suffuse::io
