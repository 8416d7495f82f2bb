// Every sheet of tests/sheets/ gives what the file next to it expects: tests/sheets/README.md.

#include "suffuse/gradings/sheets_for_tests.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/reference.hpp"
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace suffuse::gradings {
namespace {

using namespace testing;
namespace fs = std::filesystem;

const std::string answer_ending = ".expected.json";

fs::path sheets_folder() {
    return test::in_checkout("tests/sheets");
}

/// With its byte order mark.
std::string all_bytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Paths below the folder, in their order.
std::vector<std::string> all_sheets() {
    std::vector<std::string> sheets;
    for (const auto& entry : fs::recursive_directory_iterator(sheets_folder())) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file() && name != "README.md" && !name.ends_with(answer_ending)) {
            sheets.push_back(entry.path().lexically_relative(sheets_folder()).string());
        }
    }
    std::ranges::sort(sheets);
    return sheets;
}

std::string answer_to(const std::string& sheet) {
    return fs::path(sheet).replace_extension().string() + answer_ending;
}

class Sheets : public ::testing::TestWithParam<std::string> {};

TEST_P(Sheets, GivesWhatItsExpectedFileStates) {
    const nlohmann::json expected = nlohmann::json::parse(all_bytes(sheets_folder() / answer_to(GetParam())));
    const ParsedSheet parsed =
        parse_sheet(all_bytes(sheets_folder() / GetParam()), fs::path(GetParam()).filename().string());
    const std::string messages = render(parsed.remarks) + "\n" + messages_of(parsed);
    for (const auto& [key, value] : expected.items()) {
        EXPECT_TRUE(std::set<std::string>({"soils", "remarks", "refused", "tolerance", "with"}).contains(key)) << key;
    }

    SheetTolerance tolerance;
    if (expected.contains("tolerance")) {
        tolerance = {expected["tolerance"].at("size"), expected["tolerance"].at("passing")};
    }
    ASSERT_EQ(parsed.soils.size(), expected.at("soils").size()) << messages;
    for (std::size_t k = 0; k < parsed.soils.size(); ++k) {
        const nlohmann::json& soil = expected["soils"][k];
        expect_soil({soil.at("name"), soil.at("curve")}, parsed.soils[k], GetParam(), tolerance);
    }
    const nlohmann::json none = nlohmann::json::array();
    for (const std::string words : expected.value("remarks", none)) {
        EXPECT_NE(messages.find(words), std::string::npos) << words << "\n" << messages;
    }
    if (expected.contains("remarks") && expected["remarks"].empty()) {
        EXPECT_EQ(messages.find("W508"), std::string::npos) << messages;
    }
    if (expected.contains("with")) {
        const nlohmann::json& with = expected["with"];
        const nlohmann::json& words = with.at("options");
        ReadingOptions options;
        options.size = words.at("size");
        for (const auto& [key, member] :
             {std::pair{"passing", &ReadingOptions::passing},
              {"retained", &ReadingOptions::retained},
              {"share", &ReadingOptions::share},
              {"mass", &ReadingOptions::mass},
              {"rows", &ReadingOptions::rows}}) {
            options.*member = words.value(key, "");
        }
        const ParsedSheet named = parse_sheet(all_bytes(sheets_folder() / GetParam()), "sheet.csv", options);
        ASSERT_EQ(named.soils.size(), with.at("soils").size()) << render(named.remarks);
        for (std::size_t k = 0; k < named.soils.size(); ++k) {
            const nlohmann::json& soil = with["soils"][k];
            expect_soil({soil.at("name"), soil.at("curve")}, named.soils[k], GetParam(), tolerance);
        }
    }
    std::vector<Diagnostic> errors;
    std::ranges::copy_if(parsed.remarks, std::back_inserter(errors), [](const Diagnostic& d) { return !d.is_warning; });
    const nlohmann::json refusals = expected.value("refused", none);
    ASSERT_GE(errors.size(), refusals.size()) << messages;
    for (std::size_t k = 0; k < refusals.size(); ++k) {
        const std::string text = "error: " + errors[k].message + errors[k].help;
        EXPECT_NE(text.find(refusals[k].at("says").get<std::string>()), std::string::npos) << messages;
        EXPECT_EQ(errors[k].line, refusals[k].value("line", errors[k].line)) << messages;
    }
}

INSTANTIATE_TEST_SUITE_P(, Sheets, ::testing::ValuesIn(all_sheets()), [](const auto& about) {
    std::string name = about.param;
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_'
    );
    return name;
});

TEST(SheetsFolder, HasAnAnswerForEachSheetAndNoOther) {
    const std::vector<std::string> sheets = all_sheets();
    EXPECT_GE(sheets.size(), 100U);
    std::set<std::string> answers;
    for (const std::string& sheet : sheets) {
        EXPECT_TRUE(answers.insert(answer_to(sheet)).second) << "two sheets of one name: " << sheet;
    }
    for (const auto& entry : fs::recursive_directory_iterator(sheets_folder())) {
        const std::string path = entry.path().lexically_relative(sheets_folder()).string();
        EXPECT_TRUE(!path.ends_with(answer_ending) || answers.contains(path)) << "no sheet for " << path;
    }
}

} // namespace
} // namespace suffuse::gradings
