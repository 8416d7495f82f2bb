// What a state on disk must not survive unseen: a change of any of its bytes.

#include "suffuse/base/error.hpp"
#include "suffuse/base/sha256.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/hdf5_file.hpp"

#include <gtest/gtest.h>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <fstream>
#include <functional>

namespace suffuse::io {
namespace {

using test::TempFolder;

/// A state in the middle of a stage: it has everything that a file may hold.
std::string file_in_a_stage(const TempFolder& folder) {
    dem::World world;
    for (const double x : {0.1, 0.2, 0.35}) {
        grains::add_grain(world.grains, {x, 0.5, 0.5}, 0.08, 2600);
        world.grains.force.back() = world.grains.torque.back() = {x, -x, 1};
    }
    world.contacts.first = {0, 1}, world.contacts.second = {1, 2};
    world.contacts.image = {{0, 0, 0}, {1, 0, 0}};
    world.contacts.overlap = {1e-3, 2e-3};
    for (contact::VectorColumn* column :
         {&world.contacts.shear_force, &world.contacts.bending, &world.contacts.normal}) {
        column->resize(2);
        column->set(0, {0, 0, 1}), column->set(1, {1, 0, 0});
    }
    const std::vector<std::uint8_t> unfinished{1, 2, 3, 4, 5};
    save_world(folder / "partial.h5", world, {{"stage", "s/shear"}}, {{"case_hash", "0123"}}, unfinished);
    return test::read_all(folder / "partial.h5");
}

bool is_refused(const std::function<void()>& load) {
    try {
        load();
        return false;
    } catch (const IoError&) {
        return true;
    }
}

TEST(DamagedState, ABitThatChangesInAFileIsSeenWhereverItIs) {
    const TempFolder folder;
    const std::string whole = file_in_a_stage(folder);
    std::fstream file(folder / "partial.h5", std::ios::binary | std::ios::in | std::ios::out);
    const auto put = [&](std::size_t at, char byte) {
        file.seekp(static_cast<std::streamoff>(at));
        file.put(byte).flush();
    };
    std::vector<std::size_t> unseen;
    for (std::size_t at = 0; at < whole.size(); at += 3) { // all of them take seconds; each bit of a byte gets its turn
        put(at, static_cast<char>(whole[at] ^ (1 << at % 8)));
        if (!is_refused([&] { load_world(folder / "partial.h5"); })) {
            unseen.push_back(at);
        }
        put(at, whole[at]);
    }
    EXPECT_EQ(unseen, std::vector<std::size_t>{});
    EXPECT_TRUE(load_world(folder / "partial.h5").is_hashed); // every byte came back
}

TEST(DamagedState, ABitThatChangesInBytesForAnotherProcessIsSeen) {
    const TempFolder folder;
    std::string bytes = file_in_a_stage(folder);
    for (std::size_t at = 0; at < bytes.size(); at += 31) {
        const char good = bytes[at];
        bytes[at] = static_cast<char>(good ^ (1 << at % 8));
        EXPECT_TRUE(is_refused([&] { static_cast<void>(world_from_bytes(bytes)); })) << at;
        bytes[at] = good;
    }
    EXPECT_EQ(world_from_bytes(bytes).grains.size(), 3U);
}

// What disks and file systems lose comes in blocks.
TEST(DamagedState, BlocksThatAreLostOrExchangedAreSeen) {
    const TempFolder folder;
    const std::string whole = file_in_a_stage(folder);
    constexpr std::size_t block = 512;
    for (std::size_t at = 0; at + 2 * block <= whole.size(); at += block) {
        std::string lost = whole, exchanged = whole;
        const auto begin = static_cast<std::ptrdiff_t>(at);
        std::fill_n(lost.begin() + begin, block, '\0');
        std::swap_ranges(
            exchanged.begin() + begin, exchanged.begin() + begin + block, exchanged.begin() + begin + block
        );
        for (const std::string& changed : {lost, exchanged}) {
            EXPECT_TRUE(changed == whole || is_refused([&] { static_cast<void>(world_from_bytes(changed)); })) << at;
        }
    }
}

TEST(DamagedState, TheMessageNamesTheFileAndSaysWhatHelps) {
    const TempFolder folder;
    std::string bytes = file_in_a_stage(folder);
    ++bytes[bytes.find("s/shear")];
    write_file(folder / "partial.h5", bytes);
    try {
        load_world(folder / "partial.h5");
        FAIL() << "it was read";
    } catch (const IoError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find((folder / "partial.h5").string()), std::string::npos) << text;
        EXPECT_NE(text.find("was changed or damaged after it was written; use a whole copy"), std::string::npos);
    }
}

TEST(DamagedState, ItsDigestIsThatOfTheFileWithZerosInItsPlace) {
    const TempFolder folder;
    std::string bytes = file_in_a_stage(folder);
    const std::string digits = Hdf5Reader(folder / "partial.h5").read_text("sha256");
    bytes.replace(bytes.find(digits), digits.size(), digits.size(), '0');
    Sha256 hash;
    hash.add(bytes);
    EXPECT_EQ(digits, hash.hex());
}

TEST(DamagedState, AFileThatGrowsAfterItWasCompletedIsCompletedAgain) {
    const TempFolder folder;
    const double one = 1, two = 2;
    Hdf5Writer file;
    file.write("one", {}, &one, "m");
    EXPECT_EQ(Hdf5Reader(file.image(), "the first image").read<double>("one"), std::vector<double>{1});
    file.write("two", {}, &two, "m");
    const Hdf5Reader grown(file.image(), "the second image");
    EXPECT_TRUE(grown.has_digest());
    EXPECT_EQ(grown.read<double>("two"), std::vector<double>{2});
}

TEST(DamagedState, AStateOfBeforeThereWereDigestsOpensAndSaysThatItHasNone) {
    const TempFolder folder;
    write_file(folder / "state.h5", test::read_reference("state_without_digest.h5.gz"));
    const Checkpoint old = load_world(folder / "state.h5");
    EXPECT_FALSE(old.is_hashed);
    EXPECT_EQ(dem::state_hash(old.world), 0x77d71fde9f5b785dU);
    EXPECT_EQ(old.world.grains.size(), 4U);
    EXPECT_EQ(old.attributes.at("stage"), "s/initial");
    EXPECT_EQ(old.unfinished.size(), 28U);
    save_world(folder / "again.h5", old.world);
    EXPECT_TRUE(load_world(folder / "again.h5").is_hashed);
}

} // namespace
} // namespace suffuse::io
