#include "suffuse/io/hdf5_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/io/atomic_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <atomic>
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

} // namespace
} // namespace suffuse::io
