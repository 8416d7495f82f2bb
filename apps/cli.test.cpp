// The program as a whole: help, wrong use, hostile words, and where words go.

#include "tests/support/program.hpp"
#include "tests/support/reference.hpp"
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace suffuse {
namespace {

using namespace test;

TEST_F(Cli, AloneAndWithHelpItSaysHowToBegin) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"--help"}}) {
        const ProgramResult result = run_suffuse(words);
        EXPECT_EQ(result.code, 0);
        EXPECT_EQ(result.error, "");
        expect_in("suffuse run", result.out);
        expect_in("exit codes", result.out);
    }
    expect_in("suffuse 0.", run_suffuse({"--version"}).out);
    EXPECT_EQ(run_suffuse({"help"}).out, run_suffuse({"--help"}).out);
    EXPECT_EQ(run_suffuse({"help", "run"}).out, run_suffuse({"run", "--help"}).out);
    EXPECT_EQ(run_suffuse({"-q", "--color", "never", "help", "run"}).out, run_suffuse({"run", "--help"}).out);
    EXPECT_EQ(run_suffuse({"help", "bench", "step"}).out, run_suffuse({"bench", "step", "--help"}).out);
}

TEST_F(Cli, EveryVerbHasAHelpOfOneScreen) {
    for (const std::string verb :
         {"run", "resume", "report", "new", "check", "plan", "explain", "schema", "bench", "import", "export"}) {
        const ProgramResult result = run_suffuse({verb, "--help"});
        EXPECT_EQ(result.code, 0) << verb;
        expect_in("suffuse " + verb + ":", result.out);
        const int most = verb == "new" ? 27 : verb == "run" ? 26 : 24; // the two have more than a screen of old holds
        EXPECT_LE(std::count(result.out.begin(), result.out.end(), '\n'), most) << verb;
        EXPECT_EQ(result.out.find("OPTION"), std::string::npos) << result.out; // the parsing library's own words
    }
}

TEST_F(Cli, EveryVerbHasItsSectionInTheDocumentation) {
    const std::string page = test::read_all(test::in_checkout("docs/verbs.md"));
    const std::string overview = run_suffuse({}).out;
    std::istringstream lines(overview.substr(overview.find("verbs\n") + 6));
    std::set<std::string> files;
    for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
        const std::string verb = line.substr(2, line.find(' ', 2) - 2);
        files.insert("verb_" + verb + ".cpp");
        const std::size_t at = page.find("`" + verb + "`");
        ASSERT_NE(at, std::string::npos) << verb;
        EXPECT_EQ(page.compare(page.rfind('\n', at) + 1, 4, "### "), 0) << verb << " has no section";
    }
    for (const auto& entry : std::filesystem::directory_iterator(test::in_checkout("apps"))) {
        const std::string file = entry.path().filename().string();
        const bool is_verb = file.starts_with("verb_") && file.ends_with(".cpp") && !file.ends_with(".test.cpp");
        EXPECT_EQ(is_verb, files.contains(file)) << file << ": its row is in apps/verbs.hpp";
    }
}

TEST_F(Cli, WrongUseIsCodeTwoAndNamesWhatIsNear) {
    struct Wrong {
        std::vector<std::string> words;
        std::string part;
    };

    for (const Wrong& wrong : std::vector<Wrong>{
             {{"rnu", "case.toml"}, "run"},
             {{"run", "case.toml", "--presett", "quick"}, "--preset"},
             {{"check", "case.toml", "--until", "initial"}, "run, resume, plan have it"},
             {{"watch", "runs/a", "--sample", "b"}, "resume, new, assess have it"},
             {{"nonsense", "--help"}, "unknown verb nonsense"},
             {{"hlep"}, "help"},
             {{test::in_checkout("README.md")}, "it is a file. A grading: suffuse assess"},
             {{"help", "rnu"}, "run"},
             {{"bench", "stpe"}, "step"},
             {{"bench", "stpe", "--help"}, "step"},
             {{"bench"}, "bench what?"},
             {{"bench", "flow", "--cell", "1,2,3"}, "--cell is that of a --packing"},
             {{"bench", "step", "--packing", "p.csv", "--mode", "quick"}, "reference"},
             {{"run"}, "CASE"},
             {{"run", "a.toml", "b.toml"}, "b.toml"},
             {{"run", "a.toml", "-j", "0"}, "threads"},
             {{"run", "a.toml", "-j", "two"}, "threads"},
             {{"assess", "a.csv", "-i"}, "--gradient needs a value"},
             {{"run", "a.toml", "-o"}, "--output needs a value"},
             {{"run", "a.toml", "--time-limit", "90"}, "90min"},
             {{"run", "a.toml", "--time-limit", "0"}, "write 90min"},
             {{"run", "a.toml", "--time-limit", "90 kPa"}, "time"},
             {{"run", "a.toml", "--time-limit", "9m"}, "for minutes write 9min"},
             {{"check", "a.toml", "--color", "red"}, "auto, always or never"},
             {{"new", "--from", "fontanebleau-2016"}, "fontainebleau-2016"},
             {{"explain", "wacht"}, "watch"},
             {{"bench", "step", "--packing", "p.csv", "--cell", "1,2"}, "--cell"},
             {{"bench", "step", "--packing", "p.csv", "--cell", "1,2,-3"}, "--cell"},
             {{"bench", "step", "--packing", "p.csv", "--cell", "1,2,nan"}, "--cell"},
         }) {
        const ProgramResult result = run_suffuse(wrong.words);
        EXPECT_EQ(result.code, 2) << wrong.words[0] << ": " << result.error;
        EXPECT_EQ(result.out, "");
        expect_in(wrong.part, result.error);
    }
}

TEST_F(Cli, NumbersOutOfRangeAreReportedWithTheRangeInWords) {
    struct Wrong {
        std::vector<std::string> words;
        std::string part;
    };

    for (const Wrong& wrong : std::vector<Wrong>{
             {{"assess", "a.csv", "-i", "-1"}, "-1 is not a number of 0 or more"},
             {{"assess", "a.csv", "-i", "nan"}, "nan is not a number of 0 or more"},
             {{"assess", "a.csv", "--porosity", "2"}, "2 is not a number from 0.05 to 0.95"},
             {{"cache", "--limit", "-3"}, "-3 is not a number of 0 or more"},
             {{"run", "a.toml", "-j", "0"}, "0 is not a whole number from 1 to 1024"},
             {{"run", "a.toml", "-j", "1.5"}, "1.5 is not a whole number from 1 to 1024"},
         }) {
        const ProgramResult result = run_suffuse(wrong.words);
        EXPECT_EQ(result.code, 2) << result.error;
        expect_in(wrong.part, result.error);
        EXPECT_LT(result.error.size(), 200U) << result.error;
    }
}

TEST_F(Cli, HostileWordsAreAnsweredAndShownHarmless) {
    const std::vector<std::string> hostile = {
        std::string(100'000, 'a'),
        "\x1b[2J\x1b[31m",
        "--\x1b]0;title\x07",
        "\xff\xfe",
        "%s%n",
        "../../../../etc/passwd",
        "-",
        "--",
        "",
        "--=",
        "-jjjj",
        "-99999999999999999999"};
    for (const std::string& word : hostile) {
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{word},
              {"run", word},
              {"check", word},
              {"new", "--from", word},
              {"explain", word},
              {"run", "x.toml", "--set", word},
              {"bench", "step", "--packing", word, "--cell", word},
              {"--json", word}}) {
            const ProgramResult result = run_suffuse(words);
            const bool is_known = result.code == 0 || result.code == 2 || result.code == 3 || result.code == 74;
            EXPECT_TRUE(is_known) << result.code << " for " << words[0] << " " << result.error.substr(0, 500);
            EXPECT_EQ(result.error.find('\x1b'), std::string::npos) << result.error.substr(0, 500);
            EXPECT_LT(result.error.size(), 5000U);
        }
    }
}

TEST_F(Cli, AFolderStandsForItsCaseAndARunFolderIsRecognized) {
    run_suffuse({"new", "a", "--from", "replay"});
    const ProgramResult result = run_suffuse({"check", "a"});
    EXPECT_EQ(result.code, 0) << result.error;
    expect_in("a/case.toml: no errors", result.out);
    write_to(folder / "a/run_options.json", "{}");
    const ProgramResult run = run_suffuse({"run", "a"});
    EXPECT_EQ(run.code, 2);
    expect_in("a is the folder of a run: suffuse resume", run.error);
    std::filesystem::create_directory(folder / "empty");
    expect_in("it is a folder", run_suffuse({"check", "empty"}).error);
}

TEST_F(Cli, OpenShowsTheReportByTheDesktopsProgramOrSaysWhereItLies) {
    write_to(folder / "run/report.html", "<p>");
    write_to(folder / "bin/xdg-open", "#!/bin/sh\necho \"$1\" > " + (folder / "opened").string() + "\n");
    std::filesystem::permissions(folder / "bin/xdg-open", std::filesystem::perms::owner_all);
    const std::string path = "PATH=" + (folder / "bin").string() + ":/usr/bin:/bin";
    const ProgramResult result = run_suffuse({"open", "run"}, {path});
    EXPECT_EQ(result.code, 0) << result.error;
    expect_in("run/report.html", result.out);
    expect_in("run/report.html", read_all(folder / "opened"));
    const ProgramResult alone = run_suffuse({"open", "run"}, {"PATH=" + (folder / "none").string()});
    EXPECT_EQ(alone.code, 0);
    expect_in("no browser could be opened", alone.error);
    EXPECT_EQ(run_suffuse({"open", "nothing"}).code, 74);
}

TEST_F(Cli, JsonIsOneDocumentInSuccessAndInFailure) {
    run_suffuse({"new", "a", "--from", "replay"});
    EXPECT_EQ(run_suffuse({"check", "a/case.toml", "--json"}).json().at("errors"), 0);
    const nlohmann::json keys = run_suffuse({"schema", "--json"}).json().at("keys");
    EXPECT_GT(keys.size(), 50U);
    const auto of = [&](const char* table, const char* name) -> const nlohmann::json& { // what a form needs
        return *std::ranges::find_if(keys, [&](const auto& key) {
            return key["table"] == table && key["name"] == name;
        });
    };
    EXPECT_EQ(of("stage.oedometer", "axis").at("choices"), nlohmann::json({"x", "y", "z"}));
    EXPECT_EQ(of("stage.oedometer", "stresses").at("is_list"), true);
    EXPECT_EQ(of("stage.cyclic", "until").at("is_table"), true);
    EXPECT_EQ(of("stage.cyclic", "cycles").at("is_table"), false);
    EXPECT_EQ(run_suffuse({"explain", "watch", "--json"}).json().at("topic"), "watch");
    const ProgramResult bad = run_suffuse({"check", "a/case.toml", "--set", "contact.shear_ratio=-1", "--json"});
    EXPECT_EQ(bad.code, 3);
    EXPECT_EQ(bad.json().at("error").at("problems").at(0).at("file"), "--set");
    const ProgramResult usage = run_suffuse({"--json", "rnu"});
    EXPECT_EQ(usage.json().at("error").at("exit_code"), 2);
    const ProgramResult missing = run_suffuse({"check", "nowhere.toml", "--json"});
    EXPECT_EQ(missing.code, 74);
    EXPECT_EQ(missing.json().at("error").at("kind"), "io");
}

TEST_F(Cli, ColorsComeOnlyOnRequest) {
    write_to(folder / "case.toml", "schema = 2\n");
    EXPECT_EQ(run_suffuse({"check", "case.toml"}).error.find('\x1b'), std::string::npos); // no terminal
    EXPECT_NE(run_suffuse({"check", "case.toml", "--color", "always"}).error.find('\x1b'), std::string::npos);
    EXPECT_EQ(run_suffuse({"check", "case.toml", "--color", "never"}).error.find('\x1b'), std::string::npos);
    EXPECT_EQ(run_suffuse({"check", "case.toml"}, {"NO_COLOR=1"}).error.find('\x1b'), std::string::npos);
}

TEST_F(Cli, AFullDiskBehindStandardOutputIsCode74) {
    const pid_t child = fork();
    if (child == 0) {
        dup2(open("/dev/full", O_WRONLY), 1);
        dup2(open("/dev/null", O_WRONLY), 2);
        execl(SUFFUSE_PROGRAM, "suffuse", "schema", static_cast<char*>(nullptr));
        _exit(98);
    }
    EXPECT_EQ(wait_for(child).code, 74);
}

TEST_F(Cli, NothingIsWrittenIntoAFileThatTakesThePlaceOfAClosedStream) {
    for (const char* const name : {"case.toml", "packing.csv"}) {
        write_to(folder / "soil" / name, read_all(std::filesystem::path(examples) / "replay" / name));
    }
    const auto close_all = [] {
        for (const int stream : {0, 1, 2}) {
            close(stream);
        }
    };
    EXPECT_EQ(wait_for(start({"run", "soil/case.toml", "-o", "run"}, {}, close_all)).code, 0);
    EXPECT_EQ(std::filesystem::file_size(folder / "run/.lock"), 0U);
    EXPECT_EQ(run_suffuse({"verify", "run"}).code, 0);
}

} // namespace
} // namespace suffuse
