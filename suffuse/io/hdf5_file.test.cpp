#include "suffuse/io/hdf5_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include "tests/support/temp_folder.hpp"
#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

namespace suffuse::io {
namespace {

using test::TempFolder;

TEST(Hdf5File, ArraysComeBackWithShapeTypeAndUnit) {
    const TempFolder folder;
    const std::vector<double> values{1, 2, 3, 4, 5, 6};
    const std::int64_t number = -7;
    Hdf5Writer writer;
    writer.write("a/b/values", {3, 2}, values.data(), "m/s");
    writer.write("number", {}, &number, "");
    writer.write<std::uint8_t>("a/none", {0}, nullptr, "kg");
    writer.save(folder / "f.h5");

    const Hdf5Reader reader(folder / "f.h5");
    EXPECT_EQ(reader.shape("a/b/values"), (Shape{3, 2}));
    EXPECT_EQ(reader.read<double>("a/b/values"), values);
    EXPECT_EQ(reader.unit("a/b/values"), "m/s");
    EXPECT_EQ(reader.read<std::int64_t>("number"), std::vector<std::int64_t>{-7});
    EXPECT_EQ(reader.unit("number"), "");
    EXPECT_EQ(reader.read<std::uint8_t>("a/none").size(), 0U);
    EXPECT_EQ(reader.names("a"), (std::vector<std::string>{"b", "none"}));
    EXPECT_TRUE(reader.names("nothing").empty());
    EXPECT_TRUE(reader.has("a/b"));
    EXPECT_FALSE(reader.has("a/c/d"));
}

// Samples of a sweep save their states whenever they like, also at the same moment.
TEST(Hdf5File, SeveralThreadsReadAndWriteAtTheSameTime) {
    const TempFolder folder;
    std::vector<std::jthread> threads;
    std::atomic<int> good{0};
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            const std::filesystem::path path = folder / fmt::format("{}.h5", t);
            for (int k = 0; k < 20; ++k) {
                const std::vector<double> values(1000, 100 * t + k);
                Hdf5Writer writer;
                writer.write("values", {values.size()}, values.data(), "m");
                writer.save(path);
                good += Hdf5Reader(path).read<double>("values") == values ? 1 : 0;
            }
        });
    }
    threads.clear(); // waits for all
    EXPECT_EQ(good, 80);
}

TEST(Hdf5File, HasTheSameBytesWheneverItIsWritten) {
    const TempFolder folder;
    const auto write = [&](const char* name) {
        const double value = 1.5;
        Hdf5Writer file;
        file.write("grains/radius", {}, &value, "m");
        file.write_text("kind", "state");
        file.write_attribute("program", "suffuse");
        file.save(folder / name);
    };
    write("now.h5");
    const std::time_t then = std::time(nullptr);
    while (std::time(nullptr) == then) { // HDF5 counts seconds
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    write("later.h5");
    EXPECT_EQ(test::read_all(folder / "now.h5"), test::read_all(folder / "later.h5"));
}

TEST(Hdf5File, TextsMayBeEmptyOrLong) {
    const TempFolder folder;
    const std::string text = std::string(200'000, 'x') + "\n\"ä\"";
    Hdf5Writer writer;
    writer.write_text("t/long", text);
    writer.write_text("t/empty", "");
    writer.save(folder / "f.h5");
    const Hdf5Reader reader(folder / "f.h5");
    EXPECT_EQ(reader.read_text("t/long"), text);
    EXPECT_EQ(reader.read_text("t/empty"), "");
}

TEST(Hdf5File, WhatDoesNotFitIsRefused) {
    const TempFolder folder;
    const double one = 1;
    Hdf5Writer writer;
    writer.write("v", {}, &one, "");
    writer.save(folder / "f.h5");
    const Hdf5Reader reader(folder / "f.h5");
    EXPECT_THROW((void)reader.read<std::int32_t>("v"), IoError);
    EXPECT_THROW((void)reader.read<double>("w"), IoError);
    EXPECT_THROW((void)reader.read_text("v"), IoError);
    EXPECT_THROW(Hdf5Reader(folder / "none.h5"), IoError);
    write_file(folder / "text.h5", "this is no HDF5 file");
    EXPECT_THROW(Hdf5Reader(folder / "text.h5"), IoError);
    write_file(folder / "half.h5", test::read_all(folder / "f.h5").substr(0, 900));
    EXPECT_THROW(Hdf5Reader(folder / "half.h5"), IoError);
}

// A damaged file may hold what our writer never makes.
TEST(Hdf5File, ImpossibleShapesAreRefusedBeforeTheyAllocateMemory) {
    const TempFolder folder;
    const std::string path = (folder / "f.h5").string();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const auto add = [&](const char* name, hid_t type, const std::vector<hsize_t>& sizes) {
        const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
        const hid_t data = H5Dcreate2(file, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        EXPECT_GE(data, 0);
        const hid_t unit = H5Acreate2(data, "unit", type, space, H5P_DEFAULT, H5P_DEFAULT);
        H5Aclose(unit);
        H5Dclose(data);
        H5Sclose(space);
    };
    const hid_t text = H5Tcopy(H5T_C_S1);
    H5Tset_size(text, 8);
    add("huge", H5T_NATIVE_DOUBLE, {hsize_t{1} << 50});
    add("texts", text, {1000});
    H5Tclose(text);
    H5Fclose(file);

    const Hdf5Reader reader(path);
    EXPECT_THROW((void)reader.read<double>("huge"), IoError);
    EXPECT_THROW((void)reader.read_text("texts"), IoError); // one text has room for one
    EXPECT_THROW((void)reader.unit("texts"), IoError);
}

} // namespace
} // namespace suffuse::io
