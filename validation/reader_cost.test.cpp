// What it costs to read a grading or a packing grows as its text does. Four times the text may take four times the
// processor's time of this thread, sixteen times would be a loop within a loop: the limit lies halfway between, on a
// scale of powers. It is no limit on time, so that neither the machine nor its load matters.

#include "suffuse/gradings/read_grading.hpp"
#include "suffuse/io/packing_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <ctime>
#include <fstream>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace suffuse::io {
namespace {

constexpr double limit = 8; // between 4 and 16

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The least of five: what else runs can only add to it.
double least_time(const std::function<void()>& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 5; ++k) {
        const double begin = processor_time();
        work();
        least = std::min(least, processor_time() - begin);
    }
    return least;
}

void expect_linear(
    const std::string& what, std::size_t size, const std::function<std::string(std::size_t)>& write,
    const std::function<void(const std::string&)>& read
) {
    const std::string small = write(size), large = write(4 * size);
    const double once = least_time([&] { read(small); }), four_times = least_time([&] { read(large); });
    EXPECT_LT(four_times / once, limit * static_cast<double>(large.size()) / (4 * static_cast<double>(small.size())))
        << what << ": " << once << " s and " << four_times << " s";
}

void read_as_gradings(const std::string& text) {
    Problems problems;
    const auto soils = gradings::parse_gradings(
        std::make_shared<Source>(Source{"sheet.csv", text}), problems, gradings::CurveEnds::MayBeOpen
    );
    EXPECT_FALSE(soils.empty()) << render(problems.sorted());
}

std::string many_sieves(std::size_t count) {
    std::string text = "d [mm],passing [%]\n";
    for (std::size_t k = 1; k <= count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(count);
        text += fmt::format("{:.8f},{:.6f}\n", 0.01 + 10 * share, 100 * share);
    }
    return text;
}

std::string many_rows_of_samples(std::size_t count) {
    std::string text = "Sample,d [mm],passing [%]\n";
    for (std::size_t k = 0; k < count; ++k) {
        text += fmt::format("TP{0},2,100\nTP{0},0.4,40\nTP{0},0.06,5\n", k);
    }
    return text;
}

std::string many_samples_across(std::size_t count) {
    std::string text = "Sample,4.75 mm,0.425 mm,0.075 mm\n";
    for (std::size_t k = 0; k < count; ++k) {
        text += fmt::format("TP{},100,40,8\n", k);
    }
    return text;
}

std::string many_columns(std::size_t count) {
    std::string text = "Sieve (mm)";
    for (std::size_t k = 0; k < count; ++k) {
        text += fmt::format(",TP{} passing (%)", k);
    }
    for (const char* row : {"4.75,100", "0.425,40", "0.075,8"}) {
        const std::string line = row;
        text += "\n" + line.substr(0, line.find(','));
        for (std::size_t k = 0; k < count; ++k) {
            text += line.substr(line.find(','));
        }
    }
    return text;
}

std::string many_tables(std::size_t count) {
    std::string text;
    for (std::size_t k = 0; k < count; ++k) {
        text += fmt::format("Sample: TP{}\nd [mm],passing [%]\n2,100\n0.4,40\n0.06,5\nD60,0.8\n\n", k);
    }
    return text;
}

TEST(ReaderCost, OfGradingsGrowsAsTheirText) {
    expect_linear("sieves", 10'000, many_sieves, read_as_gradings);
    expect_linear("rows of samples", 2'000, many_rows_of_samples, read_as_gradings);
    expect_linear("samples across", 2'000, many_samples_across, read_as_gradings);
    expect_linear("columns", 480, many_columns, read_as_gradings);
    expect_linear("tables", 500, many_tables, read_as_gradings);
}

TEST(ReaderCost, OfPackingsGrowsAsTheirText) {
    const test::TempFolder folder;
    const auto read = [&folder](const std::string& text) {
        std::ofstream(folder / "p.csv", std::ios::binary) << text;
        EXPECT_GT(read_packing(folder / "p.csv", 2600).grains.size(), 0U);
    };
    const auto rows = [](std::size_t count, const std::string& mark) {
        std::string text = mark == "," ? "x,y,z,r\n" : "";
        for (std::size_t k = 0; k < count; ++k) { // on a lattice, so that none overlaps
            text += fmt::format("{1}{0}{2}{0}{3}{0}0.4\n", mark, k % 50, k / 50 % 50, k / 2500);
        }
        return text;
    };
    expect_linear(
        "csv", 20'000, [&](std::size_t n) { return rows(n, ","); }, read
    );
    expect_linear(
        "blanks", 20'000, [&](std::size_t n) { return rows(n, " "); }, read
    );
    expect_linear(
        "wide", 8'000,
        [](std::size_t n) {
            std::string text = "x,y,z,r", values = "1,2,3,0.5";
            for (std::size_t k = 0; k < n; ++k) {
                text += fmt::format(",c{}", k), values += ",1";
            }
            return text + "\n" + values + "\n";
        },
        read
    );
}

TEST(ReaderCost, OfReportingProblemsGrowsLinearly) {
    std::string messages;
    const auto times = [&messages](int count) {
        std::vector<Diagnostic> list;
        for (int k = 1; k <= count; ++k) {
            Diagnostic problem{"E203", "case.toml", k, 1, 1, "key = 1", "unknown key `key`", "", "", false};
            problem.help = "keys here are `title`";
            list.push_back(problem);
        }
        return least_time([&] { messages = render(list); });
    };
    const double once = times(2'000), four_times = times(8'000);
    EXPECT_LT(four_times / once, limit);
    EXPECT_NE(messages.find("and 7996 more with the same advice"), std::string::npos) << messages;
}

} // namespace
} // namespace suffuse::io
