// The program as a user calls it: exit codes, what goes where, and that no input makes it fall.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/temp_folder.hpp"
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace suffuse {
namespace {

using test::read_all;
using test::TempFolder;

const std::string examples = SUFFUSE_SOURCE_DIR "/examples/";

struct Said {
    int code = -1; ///< minus the signal where one ended it
    std::string out, error;

    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

void write_to(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what << " is not in the text";
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

/// Up to ten seconds.
template <class Condition>
void wait_until(Condition is_true) {
    for (int k = 0; k < 1000 && !is_true(); ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

/// A folder to work in, and the program in it.
class Cli : public testing::Test {
protected:
    pid_t start(const std::vector<std::string>& words, const std::vector<std::string>& environment = {}) {
        write_to(folder / "error", ""); // what was said before is not what is said now
        const pid_t child = fork();
        if (child != 0) {
            return child;
        }
        if (chdir(folder.path().c_str()) != 0) {
            _exit(99);
        }
        for (const auto& [name, descriptor] : {std::pair{"out", 1}, std::pair{"error", 2}}) {
            dup2(open(name, O_CREAT | O_TRUNC | O_WRONLY, 0666), descriptor);
        }
        for (const std::string& variable : environment) {
            putenv(const_cast<char*>(variable.c_str()));
        }
        std::vector<char*> arguments{const_cast<char*>("suffuse")};
        for (const std::string& word : words) {
            arguments.push_back(const_cast<char*>(word.c_str()));
        }
        arguments.push_back(nullptr);
        execv(SUFFUSE_PROGRAM, arguments.data());
        _exit(98);
    }

    Said wait_for(pid_t child) {
        int status = 0;
        while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        return {
            WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_all(folder / "out"),
            read_all(folder / "error")};
    }

    Said say(const std::vector<std::string>& words, const std::vector<std::string>& environment = {}) {
        return wait_for(start(words, environment));
    }

    /// The replay example with one text replaced; the message of `check` and its code.
    Said check_with(const std::string& what, const std::string& with) {
        write_to(folder / "case.toml", replaced(read_all(examples + "replay/case.toml"), what, with));
        write_to(folder / "packing.csv", read_all(examples + "replay/packing.csv"));
        return say({"check", "case.toml"});
    }

    TempFolder folder;
};

void expect_in(const std::string& part, const std::string& text) {
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}

TEST_F(Cli, AloneAndWithHelpItSaysHowToBegin) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{}, {"--help"}}) {
        const Said said = say(words);
        EXPECT_EQ(said.code, 0);
        EXPECT_EQ(said.error, "");
        expect_in("suffuse run", said.out);
        expect_in("exit codes", said.out);
    }
    expect_in("suffuse 0.", say({"--version"}).out);
}

TEST_F(Cli, EveryVerbHasAHelpOfOneScreen) {
    for (const std::string verb :
         {"run", "resume", "report", "new", "check", "plan", "explain", "schema", "bench", "import", "export"}) {
        const Said said = say({verb, "--help"});
        EXPECT_EQ(said.code, 0) << verb;
        expect_in("suffuse " + verb + ":", said.out);
        EXPECT_LE(std::count(said.out.begin(), said.out.end(), '\n'), 24) << verb;
        EXPECT_EQ(said.out.find("OPTION"), std::string::npos) << said.out; // the parsing library's own words
    }
}

TEST_F(Cli, EveryVerbHasItsSectionInTheDocumentation) {
    const std::string page = test::read_all(SUFFUSE_SOURCE_DIR "/docs/verbs.md");
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
             {{"bench", "stpe"}, "step"},
             {{"bench"}, "bench what?"},
             {{"bench", "step", "--packing", "p.csv", "--mode", "quick"}, "reference"},
             {{"run"}, "CASE"},
             {{"run", "a.toml", "b.toml"}, "b.toml"},
             {{"run", "a.toml", "-j", "0"}, "threads"},
             {{"run", "a.toml", "-j", "two"}, "threads"},
             {{"run", "a.toml", "--time-limit", "90"}, "90min"},
             {{"run", "a.toml", "--time-limit", "90 kPa"}, "time"},
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

TEST_F(Cli, ExplainsKeysCodesFiguresAndCriteria) {
    for (const auto& [word, part] : std::vector<std::pair<std::string, std::string>>{
             {"contact.modulus", "356 MPa"},
             {"E310", "unit"},
             {"conventions", "compression positive"},
             {"figure-9", "`detach` stage"},
             {"9", "Figure 9"},
             {"own-rules", "agree"},
             {"kezdi-1979", "<= 4"}}) {
        const Said said = say({"explain", word});
        EXPECT_EQ(said.code, 0) << word;
        expect_in(part, said.out);
        EXPECT_LE(std::count(said.out.begin(), said.out.end(), '\n'), 24) << word;
    }
    expect_in("figure-12", say({"explain", "figur-12"}).error);
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

TEST_F(Cli, NewCheckAndPlanWorkOnEveryTemplate) {
    for (const auto& entry : std::filesystem::directory_iterator(examples)) {
        const std::string name = entry.path().filename();
        if (!std::filesystem::exists(entry.path() / "case.toml")) {
            continue; // scripts, not a case
        }
        const Said made = say({"new", name, "--from", name});
        ASSERT_EQ(made.code, 0) << made.error;
        expect_in(name + "/case.toml", made.out);
        EXPECT_TRUE(read_all(folder / (name + "/case.toml")) == read_all(entry.path() / "case.toml")) << name;
        EXPECT_EQ(say({"check", name + "/case.toml"}).code, 0);
        const Said plan = say({"plan", name + "/case.toml", "--json"});
        ASSERT_EQ(plan.code, 0) << plan.error;
        EXPECT_GT(plan.json().at("stages").size(), 3U);
        EXPECT_GT(plan.json().at("seconds").at(1), plan.json().at("seconds").at(0));
        EXPECT_EQ(say({"new", name, "--from", name}).code, 2); // nothing is overwritten
    }
}

TEST_F(Cli, ErrorsOfACaseAreCodeThreeWithFileAndLine) {
    struct Slip {
        std::string what, with, line, part;
    };

    for (const Slip& slip : std::vector<Slip>{
             {R"("356 MPa")", "356e6", "case.toml:10:", "kPa"},
             {R"("2600 kg/m^3")", R"("-2600 kg/m^3")", "case.toml:6:", "above 0"},
             {R"(pressure = "100 kPa")", "pressure = 100", "case.toml:30:", "100 kPa"},
             {R"(pressure = "100 kPa")", R"(pressure = "100 mm")", "case.toml:30:", "pressure"},
             {"shear_ratio       = 0.42", "shear_ratoi       = 0.42", "case.toml:11:", "shear_ratio"},
             {"shear_ratio       = 0.42", "shear_ratio       = nan", "case.toml:11:", "finite"},
             {R"(do      = "import")", R"(do      = "improt")", "case.toml:", "import"},
             {R"("packing.csv")", R"("nothing.csv")", "case.toml:", "nothing.csv"},
             {"schema = 1", "schema = \xef\xbb\xca", "case.toml:2:", ""},
             {"[study.replay]\n", "[.a]\n", "case.toml:", ""},
         }) {
        const Said said = check_with(slip.what, slip.with);
        EXPECT_EQ(said.code, 3) << slip.with << ": " << said.error;
        expect_in(slip.line, said.error);
        expect_in(slip.part, said.error);
    }
}

TEST_F(Cli, BadGradingsAreCodeThreeWithFileAndLine) {
    struct Slip {
        std::string what, with, part;
    };

    const std::string good = read_all(examples + "fontainebleau-2016/data/fontainebleau.csv");
    write_to(folder / "case.toml", read_all(examples + "fontainebleau-2016/case.toml"));
    for (const Slip& slip : std::vector<Slip>{
             {"0.21,50", "0.21,20", "fontainebleau.csv:"},
             {"0.21,50", "-0.21,50", "fontainebleau.csv:"},
             {"0.21,50", "0.21,nan", "fontainebleau.csv:"},
             {"0.21,50", "0.21,150", "fontainebleau.csv:"},
             {good, "", "fontainebleau.csv"},
         }) {
        write_to(folder / "data/fontainebleau.csv", replaced(good, slip.what, slip.with));
        const Said said = say({"check", "case.toml"});
        EXPECT_EQ(said.code, 3) << slip.with << ": " << said.error;
        expect_in(slip.part, said.error);
    }
    write_to(folder / "data/fontainebleau.csv", good);
    const Said small = say({"check", "case.toml", "--set", "study.erosion.particles=20"});
    EXPECT_EQ(small.code, 3) << small.error;
    expect_in("grains", small.error);
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

TEST_F(Cli, ARunLeavesItsResultsOnStandardOutputAndItsTalkOnStandardError) {
    say({"new", "soil", "--from", "replay"});
    const Said said = say({"soil/case.toml"}); // a file alone is run
    ASSERT_EQ(said.code, 0) << said.error;
    expect_in("runs/soil-0001/report.html", said.out);
    expect_in("plan  1 study, 4 stages", said.error);
    expect_in("4/4 replay/seep", said.error);
    EXPECT_EQ(said.error.find('\x1b'), std::string::npos);
    const Said quiet = say({"run", "soil/case.toml", "-q", "--json"});
    EXPECT_EQ(quiet.error, "");
    EXPECT_EQ(quiet.json().at("folder"), "runs/soil-0002");
    EXPECT_EQ(quiet.json().at("outcome"), "done");
    EXPECT_TRUE(std::filesystem::exists(folder / "runs/soil-0002/summary.json"));
}

TEST_F(Cli, ARunGoesOnlyWhereNothingIsOverwritten) {
    say({"new", "soil", "--from", "replay"});
    write_to(folder / "mine/notes.txt", "mine");
    EXPECT_EQ(say({"run", "soil/case.toml", "-o", "mine"}).code, 2);
    EXPECT_EQ(say({"run", "soil/case.toml", "-o", "mine/notes.txt"}).code, 2);
    ASSERT_EQ(say({"run", "soil/case.toml", "-o", "here", "--until", "start"}).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "here/studies/replay/seep"));
    EXPECT_EQ(say({"run", "soil/case.toml", "-o", "here"}).code, 0); // the same case goes on
    EXPECT_TRUE(std::filesystem::exists(folder / "here/studies/replay/seep/stage.json"));
    EXPECT_EQ(say({"run", "soil/case.toml", "-o", "here", "--set", "seed=7"}).code, 3);
    const Said wrong = say({"run", "soil/case.toml", "--until", "sepe"});
    EXPECT_EQ(wrong.code, 2);
    expect_in("seep", wrong.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "runs")); // wrong use leaves nothing behind
}

TEST_F(Cli, AnUnwritableOrUnreadablePlaceIsCode74) {
    say({"new", "soil", "--from", "replay"});
    EXPECT_EQ(say({"run", "soil/case.toml", "-o", "/proc/nothing"}).code, 74);
    EXPECT_EQ(say({"report", "nowhere"}).code, 74);
    EXPECT_EQ(say({"export", "soil/packing.csv", "-o", "x.csv"}).code, 74); // no state of a run
    EXPECT_EQ(say({"new", "/proc/nothing", "--from", "replay"}).code, 74);
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

TEST_F(Cli, AStoppedRunGoesOnToTheSameBits) {
    say({"new", "soil", "--from", "replay"});
    // Long enough to be stopped within: about a second.
    const std::vector<std::string> asked = {
        "run", "soil/case.toml", "--set", "study.replay.stage.compressed.steps=20000", "--no-cache"};
    std::vector<std::string> whole = asked, cut = asked;
    whole.insert(whole.end(), {"-o", "whole"});
    cut.insert(cut.end(), {"-o", "cut", "-j", "1"});
    ASSERT_EQ(say(whole).code, 0);
    for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
        const pid_t child = start(cut);
        wait_until([&] { return read_all(folder / "error").find("plan  ") != std::string::npos; });
        wait_until([&] { return std::filesystem::exists(folder / "cut/studies/replay/compressed"); });
        expect_in("http-equiv=\"refresh\"", read_all(folder / "cut/report.html"));
        kill(child, signal);
        const Said said = wait_for(child);
        ASSERT_EQ(said.code, code) << said.error;
        expect_in("<code>suffuse resume cut</code>", read_all(folder / "cut/report.html"));
        EXPECT_EQ(read_all(folder / "cut/report.html").find("http-equiv=\"refresh\""), std::string::npos);
        expect_in("suffuse resume cut", said.out);
        EXPECT_FALSE(std::filesystem::exists(folder / "cut/studies/replay/compressed/stage.json"));
        cut = {"resume", "cut"};
    }
    const Said late = say({"resume", "cut", "--time-limit", "1 ms"});
    EXPECT_EQ(late.code, 75) << late.error;
    ASSERT_EQ(say({"resume", "cut"}).code, 0);
    expect_in("provenance-heading", read_all(folder / "cut/report.html")); // the report itself
    EXPECT_EQ(read_all(folder / "cut/report.html").find("http-equiv=\"refresh\""), std::string::npos);
    const auto hash = [&](const std::string& run) {
        return nlohmann::json::parse(read_all(folder / (run + "/studies/replay/compressed/stage.json")))
            .at("state_hash");
    };
    EXPECT_EQ(hash("cut"), hash("whole"));
}

TEST_F(Cli, TwoProgramsDoNotWorkInOneFolder) {
    say({"new", "soil", "--from", "replay"});
    const std::vector<std::string> words = {"run",  "soil/case.toml", "-o",
                                            "here", "--set",          "study.replay.stage.compressed.steps=20000"};
    const pid_t first = start(words);
    wait_until([&] { return std::filesystem::exists(folder / "here/studies/replay/compressed"); });
    const Said second = say({"resume", "here"});
    EXPECT_EQ(second.code, 2);
    expect_in("another suffuse", second.error);
    kill(first, SIGKILL);
    wait_for(first);
}

TEST_F(Cli, ReportIsWrittenAgainWithoutComputing) {
    say({"new", "soil", "--from", "replay"});
    ASSERT_EQ(say({"run", "soil/case.toml", "-o", "here"}).code, 0);
    std::filesystem::remove(folder / "here/report.html");
    const Said said = say({"report", "here"});
    EXPECT_EQ(said.code, 0) << said.error;
    EXPECT_TRUE(std::filesystem::exists(folder / "here/report.html"));
}

/// A run's figures as `report` leaves them: one chart, one drawing.
void write_figures(const std::filesystem::path& run) {
    write_to(run / "figures/fig07.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>");
    write_to(run / "figures/fig11.vl.json", R"({"data": {"values": [{"a": 1, "b": 2}, {"a": 2, "b": 3}]},
        "mark": "bar", "encoding": {"x": {"field": "a"}, "y": {"field": "b", "type": "quantitative"}},
        "description": "two < three", "$schema": "https://vega.github.io/schema/vega-lite/v6.json"})");
}

/// A stand-in for a program of the system, which notes the words that it is called with.
void write_stand_in(const std::filesystem::path& bin, const std::string& name) {
    write_to(bin / name, "#!/bin/sh\necho \"$@\" >>\"$0.called\"\n");
    std::filesystem::permissions(bin / name, std::filesystem::perms::owner_all);
}

TEST_F(Cli, FiguresAreAskedForByNumberOrNameAndAnUnknownOneIsCodeTwo) {
    write_figures(folder / "run");
    const Said drawn = say({"figures", "run", "--figure", "7", "-o", "drawn"});
    EXPECT_EQ(drawn.code, 0) << drawn.error;
    EXPECT_EQ(drawn.out, "drawn/fig07.svg\n");
    EXPECT_EQ(read_all(folder / "drawn/fig07.svg"), read_all(folder / "run/figures/fig07.svg"));
    for (const char* name : {"fig7", "fig07", "figure-7"}) {
        EXPECT_EQ(say({"figures", "run", "--figure", name, "-o", "drawn"}).code, 0) << name;
    }
    const Said unknown = say({"figures", "run", "--figure", "12"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.error.find("it has fig07, fig11"), std::string::npos) << unknown.error;
    const Said nothing = say({"figures", "nowhere"});
    EXPECT_EQ(nothing.code, 74);
    EXPECT_NE(nothing.error.find("suffuse report nowhere"), std::string::npos) << nothing.error;
}

TEST_F(Cli, FiguresSayWhatIsMissingAndCallTheConverterForPixels) {
    write_figures(folder / "run");
    write_to(folder / "empty/readme", "");
    const Said no_node = say({"figures", "run"}, {"PATH=" + (folder / "empty").string()});
    EXPECT_EQ(no_node.code, 74);
    EXPECT_NE(no_node.error.find("node is missing"), std::string::npos) << no_node.error;
    const Said no_converter =
        say({"figures", "run", "--figure", "7", "--format", "png"}, {"PATH=" + (folder / "empty").string()});
    EXPECT_EQ(no_converter.code, 74);
    EXPECT_NE(no_converter.error.find("librsvg2-bin"), std::string::npos) << no_converter.error;
    write_stand_in(folder / "bin", "rsvg-convert");
    const std::string path = "PATH=" + (folder / "bin").string() + ":/usr/bin:/bin";
    EXPECT_EQ(say({"figures", "run", "--figure", "7", "--format", "png", "-o", "drawn"}, {path}).code, 0);
    EXPECT_EQ(say({"figures", "run", "--figure", "7", "--format", "pdf", "-o", "drawn"}, {path}).code, 0);
    const std::string calls = read_all(folder / "bin/rsvg-convert.called");
    EXPECT_EQ(calls.rfind("--format png --output drawn/fig07.png --zoom 3 --background-color white ", 0), 0U) << calls;
    EXPECT_NE(calls.find("--format pdf --output drawn/fig07.pdf /"), std::string::npos) << calls;
}

TEST_F(Cli, FiguresDrawSpecificationsWhereTheirProgramIsBuilt) {
    const std::filesystem::path drawing = std::filesystem::path(SUFFUSE_PROGRAM) / "../../../report-page/figures.mjs";
    if (!std::filesystem::exists(drawing.lexically_normal())) {
        GTEST_SKIP() << "npm has not built the report's page; ./test does";
    }
    write_figures(folder / "run");
    const Said drawn = say({"figures", "run", "--json"});
    ASSERT_EQ(drawn.code, 0) << drawn.error;
    EXPECT_EQ(drawn.json()["figures"].size(), 2U);
    const std::string svg = read_all(folder / "run/figures/fig11.svg");
    EXPECT_EQ(svg.rfind("<svg", 0), 0U);
    EXPECT_NE(svg.find("<desc>two &lt; three</desc>"), std::string::npos);
}

TEST_F(Cli, PackingsTravel) {
    say({"new", "soil", "--from", "replay"});
    const std::string cell = "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3";
    const Said looked = say({"import", "soil/packing.csv", "--cell", cell, "--json"});
    EXPECT_EQ(looked.json().at("grains"), 500);
    EXPECT_NEAR(looked.json().at("void_ratio").get<double>(), 0.674, 0.001); // packing500.json: n = 0.4026
    ASSERT_EQ(say({"run", "soil/case.toml", "-o", "here", "--until", "start"}).code, 0);
    for (const std::string file : {"a.csv", "a.txt", "a.xyz"}) {
        EXPECT_EQ(say({"export", "here/studies/replay/start", "-o", file}).code, 0) << file;
    }
    EXPECT_EQ(say({"import", "a.csv", "--json"}).json().at("grains"), 500);
    EXPECT_EQ(say({"export", "here/studies/replay/start", "-o", "a.doc"}).code, 2);
}

TEST_F(Cli, BenchSpeaksTheNamesThatScriptsRelyOn) {
    say({"new", "soil", "--from", "replay"});
    const std::string cell = "1.4360856339985508e-3,1.4358137235332051e-3,1.436026846625529e-3";
    const Said step = say(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--threads", "2", "--json"}
    );
    ASSERT_EQ(step.code, 0) << step.error;
    for (const char* name :
         {"contacts_before", "grains", "contacts", "steps_per_second", "particle_steps_per_second",
          "contact_steps_per_second", "ns_per_contact", "rebuilds", "candidates_per_contact", "state_hash"}) {
        EXPECT_TRUE(step.json().contains(name)) << name;
    }
    EXPECT_EQ(step.json().at("mode"), "reference");
    const Said fast = say(
        {"bench", "step", "--packing", "soil/packing.csv", "--cell", cell, "--steps", "50", "--mode", "fast", "--json"}
    );
    ASSERT_EQ(fast.code, 0) << fast.error;
    EXPECT_EQ(fast.json().at("mode"), "fast");
    EXPECT_NE(fast.json().at("state_hash"), step.json().at("state_hash")); // single precision has been at work
    const Said flow = say({"bench", "flow", "--packing", "soil/packing.csv", "--cell", cell, "--json"});
    ASSERT_EQ(flow.code, 0) << flow.error;
    for (const char* name : {"triangulate", "conductance", "solve", "forces"}) {
        EXPECT_TRUE(flow.json().at("seconds").contains(name)) << name;
    }
}

} // namespace
} // namespace suffuse
