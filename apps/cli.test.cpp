// The program as a whole: help, wrong use, hostile words, and where words go.

#include "tests/support/program.hpp"
#include "tests/support/reference.hpp"
#include <sstream>

namespace suffuse {
namespace {

using namespace test;

TEST_F(Cli, AloneAndWithHelpItSaysHowToBegin) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"--help"}}) {
        const Said said = say(words);
        EXPECT_EQ(said.code, 0);
        EXPECT_EQ(said.error, "");
        expect_in("suffuse run", said.out);
        expect_in("exit codes", said.out);
    }
    expect_in("suffuse 0.", say({"--version"}).out);
    EXPECT_EQ(say({"help"}).out, say({"--help"}).out);
    EXPECT_EQ(say({"help", "run"}).out, say({"run", "--help"}).out);
    EXPECT_EQ(say({"-q", "--color", "never", "help", "run"}).out, say({"run", "--help"}).out);
    EXPECT_EQ(say({"help", "bench", "step"}).out, say({"bench", "step", "--help"}).out);
}

TEST_F(Cli, EveryVerbHasAHelpOfOneScreen) {
    for (const std::string verb :
         {"run", "resume", "report", "new", "check", "plan", "explain", "schema", "bench", "import", "export"}) {
        const Said said = say({verb, "--help"});
        EXPECT_EQ(said.code, 0) << verb;
        expect_in("suffuse " + verb + ":", said.out);
        const int most = verb == "run" ? 26 : 24; // run alone has two flags more than a screen of old holds
        EXPECT_LE(std::count(said.out.begin(), said.out.end(), '\n'), most) << verb;
        EXPECT_EQ(said.out.find("OPTION"), std::string::npos) << said.out; // the parsing library's own words
    }
}

TEST_F(Cli, EveryVerbHasItsSectionInTheDocumentation) {
    const std::string page = test::read_all(test::in_checkout("docs/verbs.md"));
    const std::string overview = say({}).out;
    std::istringstream lines(overview.substr(overview.find("verbs\n") + 6));
    int verbs = 0;
    for (std::string line; std::getline(lines, line) && line.starts_with("  "); ++verbs) {
        const std::string verb = line.substr(2, line.find(' ', 2) - 2);
        const std::size_t at = page.find("`" + verb + "`");
        ASSERT_NE(at, std::string::npos) << verb;
        EXPECT_EQ(page.compare(page.rfind('\n', at) + 1, 4, "### "), 0) << verb << " has no section";
    }
    EXPECT_GE(verbs, 18);
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
             {{"run", "a.toml", "--time-limit", "90 kPa"}, "time"},
             {{"run", "a.toml", "--time-limit", "9m"}, "for minutes write 9min"},
             {{"check", "a.toml", "--color", "red"}, "auto, always or never"},
             {{"new", "--from", "fontanebleau-2016"}, "fontainebleau-2016"},
             {{"explain", "wacht"}, "watch"},
             {{"resume", "."}, "no run"},
             {{"bench", "step", "--packing", "p.csv", "--cell", "1,2"}, "--cell"},
             {{"bench", "step", "--packing", "p.csv", "--cell", "1,2,-3"}, "--cell"},
             {{"bench", "step", "--packing", "p.csv", "--cell", "1,2,nan"}, "--cell"},
         }) {
        const Said said = say(wrong.words);
        EXPECT_EQ(said.code, 2) << wrong.words[0] << ": " << said.error;
        EXPECT_EQ(said.out, "");
        expect_in(wrong.part, said.error);
    }
}

TEST_F(Cli, NumbersOutOfRangeAreToldWithTheRangeInWords) {
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
        const Said said = say(wrong.words);
        EXPECT_EQ(said.code, 2) << said.error;
        expect_in(wrong.part, said.error);
        EXPECT_LT(said.error.size(), 200U) << said.error;
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
            const Said said = say(words);
            const bool is_known = said.code == 0 || said.code == 2 || said.code == 3 || said.code == 74;
            EXPECT_TRUE(is_known) << said.code << " for " << words[0] << " " << said.error.substr(0, 500);
            EXPECT_EQ(said.error.find('\x1b'), std::string::npos) << said.error.substr(0, 500);
            EXPECT_LT(said.error.size(), 5000U);
        }
    }
}

TEST_F(Cli, AFolderStandsForTheCaseInItAndOfARunItIsSaidToBeOne) {
    say({"new", "a", "--from", "replay"});
    const Said said = say({"check", "a"});
    EXPECT_EQ(said.code, 0) << said.error;
    expect_in("a/case.toml: no errors", said.out);
    write_to(folder / "a/run_options.json", "{}");
    const Said run = say({"run", "a"});
    EXPECT_EQ(run.code, 2);
    expect_in("a is the folder of a run: suffuse resume", run.error);
    std::filesystem::create_directory(folder / "empty");
    expect_in("it is a folder", say({"check", "empty"}).error);
}

TEST_F(Cli, OpenShowsTheReportByTheDesktopsProgramOrSaysWhereItLies) {
    write_to(folder / "run/report.html", "<p>");
    write_to(folder / "bin/xdg-open", "#!/bin/sh\necho \"$1\" > " + (folder / "opened").string() + "\n");
    std::filesystem::permissions(folder / "bin/xdg-open", std::filesystem::perms::owner_all);
    const std::string path = "PATH=" + (folder / "bin").string() + ":/usr/bin:/bin";
    const Said said = say({"open", "run"}, {path});
    EXPECT_EQ(said.code, 0) << said.error;
    expect_in("run/report.html", said.out);
    expect_in("run/report.html", read_all(folder / "opened"));
    const Said alone = say({"open", "run"}, {"PATH=" + (folder / "none").string()});
    EXPECT_EQ(alone.code, 0);
    expect_in("no browser could be opened", alone.error);
    EXPECT_EQ(say({"open", "nothing"}).code, 74);
}

TEST_F(Cli, JsonIsOneDocumentInSuccessAndInFailure) {
    say({"new", "a", "--from", "replay"});
    EXPECT_EQ(say({"check", "a/case.toml", "--json"}).json().at("errors"), 0);
    EXPECT_GT(say({"schema", "--json"}).json().at("keys").size(), 50U);
    EXPECT_EQ(say({"explain", "watch", "--json"}).json().at("topic"), "watch");
    const Said bad = say({"check", "a/case.toml", "--set", "contact.shear_ratio=-1", "--json"});
    EXPECT_EQ(bad.code, 3);
    EXPECT_EQ(bad.json().at("error").at("problems").at(0).at("file"), "--set");
    const Said usage = say({"--json", "rnu"});
    EXPECT_EQ(usage.json().at("error").at("exit_code"), 2);
    const Said missing = say({"check", "nowhere.toml", "--json"});
    EXPECT_EQ(missing.code, 74);
    EXPECT_EQ(missing.json().at("error").at("kind"), "io");
}

TEST_F(Cli, ColorsComeOnlyWhenAskedFor) {
    write_to(folder / "case.toml", "schema = 2\n");
    EXPECT_EQ(say({"check", "case.toml"}).error.find('\x1b'), std::string::npos); // no terminal
    EXPECT_NE(say({"check", "case.toml", "--color", "always"}).error.find('\x1b'), std::string::npos);
    EXPECT_EQ(say({"check", "case.toml", "--color", "never"}).error.find('\x1b'), std::string::npos);
    EXPECT_EQ(say({"check", "case.toml"}, {"NO_COLOR=1"}).error.find('\x1b'), std::string::npos);
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
    EXPECT_EQ(say({"verify", "run"}).code, 0);
}

} // namespace
} // namespace suffuse
