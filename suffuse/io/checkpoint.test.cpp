#include "suffuse/io/checkpoint.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/version.hpp"
#include "suffuse/contact/carry_over.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/hdf5_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace suffuse::io {
namespace {

using test::TempFolder;

// Doubles of any bits, so that equality below is of bytes; but no signaling NaN, which any arithmetic turns into a
// quiet one.
double any_double() {
    const auto value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

Vec3 any_vector() {
    return {any_double(), any_double(), any_double()};
}

Mat3 any_matrix() {
    return from_columns(any_vector(), any_vector(), any_vector());
}

grains::Grains any_grains(int rows) {
    grains::Grains grains;
    for (int g = 0; g < rows; ++g) {
        grains.position.push_back(any_vector());
        grains.velocity.push_back(any_vector());
        grains.spin.push_back(any_vector());
        grains.force.push_back(any_vector());
        grains.torque.push_back(any_vector());
        grains.radius.push_back(any_double());
        grains.mass.push_back(any_double());
        grains.inertia.push_back(any_double());
        grains.id.push_back(*rc::gen::arbitrary<std::uint32_t>());
        grains.motion.push_back(*rc::gen::element(grains::Motion::Free, grains::Motion::Held));
        grains.fine.push_back(*rc::gen::arbitrary<std::uint8_t>());
    }
    return grains;
}

contact::Contacts any_contacts(int rows, int grains, bool twisting, bool bonds) {
    contact::Contacts contacts;
    const auto row = [&] { return static_cast<std::uint32_t>(*rc::gen::inRange(0, grains)); };
    for (int c = 0; c < rows; ++c) {
        contacts.first.push_back(row());
        contacts.second.push_back(row());
        contacts.image.push_back(
            {*rc::gen::inRange(-2, 3), *rc::gen::arbitrary<std::int16_t>(), *rc::gen::arbitrary<std::int16_t>()}
        );
        contacts.shear_force.push_back(any_vector());
        contacts.bending.push_back(any_vector());
        contacts.normal.push_back({1, any_double(), any_double()}); // touches
        contacts.overlap.push_back(any_double());
        if (twisting) {
            contacts.twisting.push_back(any_vector());
        }
        if (bonds) {
            contacts.bonded.push_back(*rc::gen::arbitrary<std::uint8_t>());
        }
    }
    return contacts;
}

dem::World any_world() {
    dem::World world;
    const int grains = *rc::gen::inRange(1, 12);
    world.cell = {any_matrix(), any_matrix()};
    world.reference_h = any_matrix();
    world.grains = any_grains(grains);
    world.contacts =
        any_contacts(*rc::gen::inRange(0, 12), grains, *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>());
    world.servo.modulus = any_vector();
    world.servo.shear_modulus = any_vector();
    world.servo.shear_stress = any_vector();
    world.clock = {*rc::gen::arbitrary<std::int64_t>(), any_double()};
    world.seed = *rc::gen::arbitrary<std::uint64_t>();
    grains::list_members(world.material, [](const grains::Member&, auto& value) {
        if constexpr (std::is_same_v<decltype(value), double&>) {
            value = any_double();
        } else {
            value = (*rc::gen::elementOf(contact::springs)).law;
        }
    });
    return world;
}

template <class T>
bool same_bytes(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bytes(const contact::VectorColumn& a, const contact::VectorColumn& b) {
    return same_bytes(a.x, b.x) && same_bytes(a.y, b.y) && same_bytes(a.z, b.z);
}

bool same(const grains::Grains& a, const grains::Grains& b) {
    return same_bytes(a.position, b.position) && same_bytes(a.velocity, b.velocity) && same_bytes(a.spin, b.spin) &&
           same_bytes(a.force, b.force) && same_bytes(a.torque, b.torque) && same_bytes(a.radius, b.radius) &&
           same_bytes(a.mass, b.mass) && same_bytes(a.inertia, b.inertia) && same_bytes(a.id, b.id) &&
           same_bytes(a.motion, b.motion) && same_bytes(a.fine, b.fine);
}

bool same(const contact::Contacts& a, const contact::Contacts& b) {
    return same_bytes(a.first, b.first) && same_bytes(a.second, b.second) && same_bytes(a.image, b.image) &&
           same_bytes(a.shear_force, b.shear_force) && same_bytes(a.bending, b.bending) &&
           same_bytes(a.normal, b.normal) && same_bytes(a.overlap, b.overlap) && same_bytes(a.twisting, b.twisting) &&
           same_bytes(a.bonded, b.bonded);
}

TEST(Checkpoint, WhatAStageNeedsToGoOnIsRefusedWhereOneByteOfItHasChanged) {
    const TempFolder folder;
    const std::string needed = "what the verb needs to go on";
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(needed.data());
    save_world(folder / "partial.h5", {}, {}, {}, {bytes, needed.size()});
    EXPECT_EQ(load_world(folder / "partial.h5").unfinished, std::vector<std::uint8_t>(bytes, bytes + needed.size()));
    std::string file = test::read_all(folder / "partial.h5");
    file.replace(file.find(needed), needed.size(), "what the verb keeps to go on");
    write_file(folder / "partial.h5", file);
    EXPECT_THROW(load_world(folder / "partial.h5"), IoError);
}

/// Bytes of each member: between them lies padding.
std::vector<std::uint64_t> bytes_of(const grains::Material& material) {
    std::vector<std::uint64_t> bytes;
    grains::list_members(material, [&](const grains::Member&, const auto& value) {
        if constexpr (std::is_same_v<decltype(value), const double&>) {
            bytes.push_back(std::bit_cast<std::uint64_t>(value));
        } else {
            bytes.push_back(static_cast<std::uint64_t>(value));
        }
    });
    return bytes;
}

RC_GTEST_PROP(Checkpoint, LoadingWhatWasSavedGivesTheSameBits, ()) {
    const dem::World world = any_world();
    const Attributes attributes{{"case", *rc::gen::nonEmpty(rc::gen::string<std::string>())}, {"stage", ""}};
    RC_PRE(attributes.at("case").find('\0') == std::string::npos);
    const TempFolder folder;
    const auto unfinished = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
    save_world(folder / "state.h5", world, attributes, {}, unfinished);
    const Checkpoint back = load_world(folder / "state.h5");
    RC_ASSERT(back.attributes == attributes);
    RC_ASSERT(back.unfinished == unfinished);
    RC_ASSERT(same(back.world.grains, world.grains));
    RC_ASSERT(same(back.world.contacts, world.contacts));
    RC_ASSERT(same_bytes(back.world.cell, world.cell));
    RC_ASSERT(same_bytes(back.world.reference_h, world.reference_h));
    RC_ASSERT(bytes_of(back.world.material) == bytes_of(world.material));
    RC_ASSERT(same_bytes(back.world.servo, world.servo));
    RC_ASSERT(same_bytes(back.world.clock, world.clock));
    RC_ASSERT(back.world.seed == world.seed);
}

dem::World two_grains() {
    dem::World world;
    grains::add_grain(world.grains, {0.25, 0.25, 0.25}, 0.1, 2600);
    grains::add_grain(world.grains, {0.5, 0.5, 0.5}, 0.1, 2600);
    world.contacts.first = {0, 0}, world.contacts.second = {1, 1};
    world.contacts.image = {{0, 0, 0}, {1, 0, 0}};
    for (contact::VectorColumn* column :
         {&world.contacts.shear_force, &world.contacts.bending, &world.contacts.normal}) {
        column->resize(2);
    }
    world.contacts.overlap = {0, 1e-3};
    world.contacts.normal.set(1, {0, 0, 1});
    return world;
}

TEST(Checkpoint, RowsThatDoNotTouchAreLeftOutAndTheHashIsTheSame) {
    const TempFolder folder;
    const dem::World world = two_grains();
    save_world(folder / "state.h5", world);
    const dem::World back = load_world(folder / "state.h5").world;
    EXPECT_TRUE(same(back.contacts, contact::touching_rows(world.contacts)));
    EXPECT_EQ(back.contacts.size(), 1U);
    EXPECT_EQ(dem::state_hash(back), dem::state_hash(world));
}

TEST(Checkpoint, TheBytesForAnotherProcessAreThoseOfTheFile) {
    const TempFolder folder;
    const dem::World world = two_grains();
    save_world(folder / "state.h5", world);
    const std::string bytes = world_to_bytes(world);
    EXPECT_EQ(bytes, test::read_all(folder / "state.h5"));
    const dem::World back = world_from_bytes(bytes);
    EXPECT_TRUE(same(back.grains, world.grains));
    EXPECT_EQ(dem::state_hash(back), dem::state_hash(world));
    for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 23) {
        EXPECT_THROW(static_cast<void>(world_from_bytes(bytes.substr(0, size))), IoError) << size;
    }
}

TEST(Checkpoint, ArraysHavePlainNamesAndUnits) {
    const TempFolder folder;
    save_world(folder / "state.h5", two_grains(), {{"case", "schema = 1"}});
    const Hdf5Reader file(folder / "state.h5");
    EXPECT_EQ(file.shape("grains/position"), (Shape{2, 3}));
    EXPECT_EQ(file.unit("grains/position"), "m");
    EXPECT_EQ(file.unit("contacts/shear_force"), "N");
    EXPECT_EQ(file.shape("cell/h"), (Shape{3, 3}));
    EXPECT_EQ(file.read_text("attributes/case"), "schema = 1");
}

/// What loading says of a state with one array replaced.
std::string complaint_about(const std::function<void(Hdf5Writer&)>& write) {
    const TempFolder folder;
    Hdf5Writer file;
    write(file);
    file.save(folder / "state.h5");
    try {
        load_world(folder / "state.h5");
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

TEST(Checkpoint, AFileRecordsItsOriginAndTheStateIsTheSame) {
    const TempFolder folder;
    dem::World world;
    world.seed = 7;
    save_world(folder / "plain.h5", world);
    save_world(folder / "marked.h5", world, {}, {{"case_hash", "0123"}, {"stage", "s/initial"}});
    EXPECT_EQ(
        dem::state_hash(load_world(folder / "marked.h5").world), dem::state_hash(load_world(folder / "plain.h5").world)
    );
    EXPECT_TRUE(load_world(folder / "marked.h5").attributes.empty());
    const Hdf5Reader file(folder / "marked.h5");
    EXPECT_EQ(file.attribute("program"), std::string("suffuse ") + version());
    EXPECT_EQ(file.attribute("commit"), commit());
    EXPECT_EQ(file.attribute("seed"), "7");
    EXPECT_EQ(file.attribute("case_hash"), "0123");
    EXPECT_EQ(file.attribute("stage"), "s/initial");
    EXPECT_THROW(static_cast<void>(file.attribute("nothing")), IoError);
}

TEST(Checkpoint, FilesThatAreNoStateAreRefused) {
    EXPECT_NE(complaint_about([](Hdf5Writer&) {}).find("not a state saved by suffuse"), std::string::npos);
    const auto start = [](Hdf5Writer& file, std::int64_t schema) {
        file.write_text("kind", "suffuse state");
        file.write("schema", {}, &schema, "");
    };
    EXPECT_NE(
        complaint_about([&](Hdf5Writer& f) { start(f, 99); }).find("schema 99, this program reads 1"), std::string::npos
    );
    const auto without_schema = [](Hdf5Writer& f) {
        f.write_text("kind", "suffuse state");
        f.write<std::int64_t>("schema", {0}, nullptr, "");
    };
    EXPECT_NE(complaint_about(without_schema).find("schema is not one number"), std::string::npos);
    EXPECT_NE(complaint_about([&](Hdf5Writer& f) { start(f, 1); }).find("cell/h is missing"), std::string::npos);
    const std::vector<double> h(9, 1.0);
    const auto misshapen = [&](Hdf5Writer& f) {
        start(f, 1);
        f.write("cell/h", {9}, h.data(), "m");
    };
    EXPECT_NE(complaint_about(misshapen).find("cell/h has another shape"), std::string::npos);
}

TEST(Checkpoint, TablesThatDoNotFitTogetherAreRefused) {
    const TempFolder folder;
    dem::World world = two_grains();
    world.contacts.second[1] = 7;
    save_world(folder / "a.h5", world);
    EXPECT_THROW(load_world(folder / "a.h5"), IoError);
    world = two_grains();
    world.grains.mass.pop_back();
    save_world(folder / "b.h5", world);
    EXPECT_THROW(load_world(folder / "b.h5"), IoError);
}

TEST(Checkpoint, DamagedFilesAreRefusedWhereverTheyWereCut) {
    const TempFolder folder;
    save_world(folder / "state.h5", two_grains());
    const std::string whole = test::read_all(folder / "state.h5");
    for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 23) {
        write_file(folder / "cut.h5", whole.substr(0, size));
        EXPECT_THROW(load_world(folder / "cut.h5"), IoError) << size;
    }
}

TEST(Checkpoint, StatesOfBeforeShearStressesAndLawsHadAChoiceHaveTheDefaults) {
    const TempFolder folder;
    dem::World world = two_grains();
    world.servo.mean_stress = world.servo.shear_modulus = world.servo.shear_stress = {1, 2, 3};
    world.material.law = grains::ContactLaw::HertzMindlin;
    world.material.poisson = 0.1, world.material.viscous_damping = 0.5, world.material.modulus = 70e9;
    save_world(folder / "new.h5", world);
    std::string file = test::read_all(folder / "new.h5");
    for (const std::string name :
         {"digest", "sha256", "shear_modulus", "shear_stress", "law", "poisson", "viscous_damping"}) {
        const std::size_t end = file.find(name + '\0') + name.size() - 1;
        ASSERT_LT(end, file.size());
        ++file[end]; // another name: none that the program knows
    }
    write_file(folder / "old.h5", file);
    const dem::World old = load_world(folder / "old.h5").world;
    const cell::ServoState& servo = old.servo;
    EXPECT_EQ(old.material.law, grains::ContactLaw::LinearRolling);
    EXPECT_EQ(old.material.poisson, grains::Material{}.poisson);
    EXPECT_EQ(old.material.viscous_damping, 0);
    EXPECT_EQ(old.material.modulus, 70e9);
    EXPECT_EQ(servo.shear_modulus, Vec3{});
    EXPECT_EQ(servo.shear_stress, Vec3{});
    EXPECT_EQ(servo.mean_stress, world.servo.mean_stress);
}

TEST(Checkpoint, EveryLawComesBackAndANumberWithoutOneIsRefused) {
    const TempFolder folder;
    dem::World world = two_grains();
    for (const contact::Spring& spring : contact::springs) {
        world.material.law = spring.law;
        save_world(folder / "state.h5", world);
        EXPECT_EQ(
            Hdf5Reader(folder / "state.h5").read<std::uint8_t>("material/law").front(), static_cast<int>(spring.law)
        );
        EXPECT_EQ(load_world(folder / "state.h5").world.material.law, spring.law);
    }
    world.material.law = static_cast<grains::ContactLaw>(contact::springs.size());
    save_world(folder / "state.h5", world);
    try {
        load_world(folder / "state.h5");
        ADD_FAILURE() << "a law that there is not was read";
    } catch (const IoError& problem) {
        for (const contact::Spring& spring : contact::springs) {
            const std::string known = fmt::format("{} ({})", static_cast<int>(spring.law), spring.words.name);
            EXPECT_NE(std::string(problem.what()).find(known), std::string::npos) << problem.what();
        }
    }
}

TEST(Checkpoint, FolderThatIsNotThereIsAnError) {
    const TempFolder folder;
    EXPECT_THROW(save_world(folder / "none/state.h5", two_grains()), IoError);
    EXPECT_EQ(folder.entries(), 0);
}

} // namespace
} // namespace suffuse::io
