// Completions and the man page, held against the flags themselves, and tried in the shells.

#include "apps/completions.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "apps/command_line.hpp"
#include "apps/man_page.hpp"
#include "tests/support/temp_folder.hpp"
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

namespace suffuse::apps {
namespace {

using test::TempFolder;

std::string text_of(std::vector<const char*> words) {
    words.insert(words.begin(), "suffuse");
    return read_command_line(static_cast<int>(words.size()), words.data()).text;
}

std::string output_of(const std::string& command) {
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> block{};
    while (std::fgets(block.data(), block.size(), pipe) != nullptr) {
        text += block.data();
    }
    return pclose(pipe) == 0 ? text : "FAILED\n" + text;
}

/// Long flags of a verb as its own help shows them.
std::set<std::string> flags_in(const std::string& help) {
    std::set<std::string> flags;
    std::istringstream words(help);
    for (std::string word; words >> word;) {
        if (word.rfind("--", 0) == 0 && word.size() > 2) {
            flags.insert(word.substr(0, word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-")));
        }
    }
    return flags;
}

/// What bash offers at the end of `line`.
std::set<std::string> offered(const TempFolder& folder, const std::string& line) {
    std::ofstream(folder / "script") << text_of({"completions", "bash"});
    std::ofstream(
        folder / "try"
    ) << "cd '"
      << folder.path().string() << "' && . ./script\nread -ra COMP_WORDS <<< '" << line << "'\n[[ '" << line
      << "' == *' ' ]] && COMP_WORDS+=('')\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_suffuse\n"
      << "printf '%s\\n' \"${COMPREPLY[@]}\"\n";
    std::istringstream out(output_of("bash --norc '" + (folder / "try").string() + "' 2>&1"));
    std::set<std::string> words;
    for (std::string word; std::getline(out, word);) {
        words.insert(word);
    }
    words.erase("");
    return words;
}

std::vector<std::string> verbs() {
    const TempFolder folder;
    const std::set<std::string> found = offered(folder, "suffuse ");
    return {found.begin(), found.end()};
}

TEST(Completions, BashOffersEveryFlagThatTheHelpNamesAndNoOther) {
    const std::vector<std::string> all = verbs();
    EXPECT_GE(all.size(), 12U);
    const TempFolder folder;
    for (const std::string& verb : all) {
        std::set<std::string> listed = flags_in(text_of({verb.c_str(), "--help"}));
        std::set<std::string> given = offered(folder, "suffuse " + verb + " --");
        given.erase("--help"), given.erase("--version");
        listed.erase("--help"), listed.erase("--version");
        std::set<std::string> missing;
        std::ranges::set_difference(given, listed, std::inserter(missing, missing.end()));
        EXPECT_TRUE(missing.empty()) << verb << ": offered but not in its help: " << *missing.begin();
        for (const std::string& flag : listed) { // examples in the help may name flags of other verbs
            if (!given.contains(flag)) {
                EXPECT_EQ(text_of({verb.c_str(), "--help"}).find("\n  " + flag), std::string::npos) << verb << flag;
            }
        }
    }
}

TEST(Completions, BashOffersValuesFilesAndVerbsBelowVerbs) {
    const TempFolder folder;
    std::ofstream(folder / "my case.toml") << "";
    std::ofstream(folder / "grains.csv") << "";
    EXPECT_EQ(offered(folder, "suffuse run --color "), (std::set<std::string>{"always", "auto", "never"}));
    EXPECT_EQ(offered(folder, "suffuse bench "), (std::set<std::string>{"flow", "scaling", "step"}));
    EXPECT_TRUE(offered(folder, "suffuse bench step --time").contains("--time-step"));
    EXPECT_TRUE(offered(folder, "suffuse explain rolling_f").contains("rolling_friction"));
    EXPECT_TRUE(offered(folder, "suffuse new --from font").contains("fontainebleau-2016"));
    const std::set<std::string> cases = offered(folder, "suffuse check ");
    EXPECT_TRUE(cases.contains("my case.toml"));
    EXPECT_FALSE(cases.contains("grains.csv"));
    EXPECT_TRUE(offered(folder, "suffuse import gr").contains("grains.csv"));
    EXPECT_TRUE(offered(folder, "suffuse --q").contains("--quiet"));
    EXPECT_TRUE(offered(folder, "suffuse my").contains("my case.toml"));
}

TEST(Completions, ZshAndFishTakeTheirScripts) {
    const TempFolder folder;
    for (const std::string shell : {"zsh", "fish"}) {
        const std::string script = text_of({"completions", shell.c_str()});
        EXPECT_NE(script.find("time-limit"), std::string::npos);
        EXPECT_NE(script.find("fontainebleau-2016"), std::string::npos);
        const std::string file = (folder / shell).string();
        std::ofstream(file) << script;
        EXPECT_EQ(output_of(fmt::format("{} -n '{}' 2>&1", shell, file)), "") << shell; // its syntax
    }
    const std::string offers = output_of(
        fmt::format("fish -c 'source \"{}\"; complete -C \"suffuse run --time\"' 2>&1", (folder / "fish").string())
    );
    EXPECT_NE(offers.find("--time-limit"), std::string::npos) << offers;
}

TEST(Completions, AnotherShellIsRefusedWithAHint) {
    try {
        text_of({"completions", "bas"});
        FAIL() << "expected a UsageError";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string(error.what()).find("a similar one exists: bash"), std::string::npos) << error.what();
    }
}

TEST(ManPage, NamesEveryVerbAndFlagAndIsGoodRoff) {
    const std::string page = text_of({"man"});
    std::string plain = page;
    plain.erase(std::remove(plain.begin(), plain.end(), '\\'), plain.end());
    for (const std::string& verb : verbs()) {
        EXPECT_NE(plain.find("suffuse " + verb), std::string::npos) << verb;
        for (const std::string& flag : flags_in(text_of({verb.c_str(), "--help"}))) {
            EXPECT_NE(plain.find(flag), std::string::npos) << verb << " " << flag;
        }
    }
    EXPECT_NE(plain.find("time limit reached"), std::string::npos); // exit status
    const TempFolder folder;
    std::ofstream(folder / "suffuse.1") << page;
    const std::string complaints =
        output_of("groff -man -Tutf8 -ww '" + (folder / "suffuse.1").string() + "' 2>&1 >/dev/null");
    EXPECT_EQ(complaints, "");
}

} // namespace
} // namespace suffuse::apps
