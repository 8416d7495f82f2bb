// Texts of a megabyte in foreign files: a message quotes their beginning and their end.

#include "tests/support/program.hpp"
#include <algorithm>
#include <sstream>

namespace suffuse {
namespace {

using namespace test;

class LongTexts : public Cli {
protected:
    LongTexts() {
        write_to(folder / "packing.csv", read_all(examples + "replay/packing.csv"));
        const std::string plain = read_all(examples + "replay/case.toml");
        write_to(folder / "value.toml", replaced(plain, "\"100 kPa\"", '"' + text + '"'));
        write_to(folder / "unit.toml", replaced(plain, "\"100 kPa\"", "\"100 " + text + '"'));
        write_to(folder / "file.toml", replaced(plain, "packing.csv", text));
        write_to(folder / "key.toml", plain + '\n' + text + " = 1\n");
        write_to(folder / "size.csv", "size (mm),passing (%)\n0.1,10\n" + text + ",20\n1,100\n");
        write_to(folder / "share.csv", "size (mm),passing (%)\n0.1,10\n0.5," + text + "\n1,100\n");
        write_to(folder / "run/run_options.json", "{\"case\": \"" + text + "\"}");
    }

    static std::size_t longest_line(const std::string& output_text) {
        std::istringstream lines(output_text);
        std::size_t longest = 0;
        for (std::string line; std::getline(lines, line);) {
            longest = std::max(longest, line.size());
        }
        return longest;
    }

    const std::string text = std::string(1'000'000, 'x');
    const std::vector<std::vector<std::string>> calls{
        {"check", "value.toml"}, {"check", "unit.toml"},  {"plan", "file.toml"}, {"check", "key.toml"},
        {"assess", "size.csv"},  {"assess", "share.csv"}, {"resume", "run"},
    };
};

TEST_F(LongTexts, AreCutInErrors) {
    for (std::vector<std::string> words : calls) {
        const ProgramResult output_text = run_suffuse(words);
        EXPECT_TRUE(output_text.code == 3 || output_text.code == 74) << words.back() << output_text.code;
        EXPECT_LT(longest_line(output_text.error), 600U) << words.back();
        expect_in("…", output_text.error);
        words.emplace_back("--json");
        const ProgramResult json = run_suffuse(words);
        EXPECT_LT(json.out.size(), 6'000U) << words[1];
        expect_in("x…x", json.json().at("error").at("message").get<std::string>());
    }
}

} // namespace
} // namespace suffuse
