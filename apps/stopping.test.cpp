// What ends a run from outside: terminals that close, pipes that break, batch systems, limits. Each finds the run in
// the middle of a stage, and nothing may be lost.

#include "tests/support/program.hpp"
#include <array>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <termios.h>

namespace suffuse {
namespace {

using namespace test;

const std::vector<std::string> cut_run = {"run", "soil/case.toml", "-o", "cut", "-j", "1", "--no-cache"};

class Stopping : public Cli {
protected:
    Stopping() {
        for (const char* const name : {"case.toml", "packing.csv"}) {
            write_to(folder / "soil" / name, read_all(std::filesystem::path(examples) / "replay" / name));
        }
    }

    HeldRun start_run(const std::function<void()>& in_child = {}) {
        return start_held("replay/compressed", cut_run, {"TERM=xterm", "LANG=C"}, in_child);
    }

    [[nodiscard]] std::filesystem::path stage(const std::string& file) const {
        return folder / ("cut/studies/replay/compressed/" + file);
    }

    /// The stage is saved half-way and nothing is half-written.
    void expect_saved() const {
        EXPECT_TRUE(std::filesystem::exists(stage("partial.h5")));
        EXPECT_FALSE(std::filesystem::exists(stage("stage.json")));
        expect_nothing_half_written();
        expect_in("suffuse resume cut", read_all(folder / "cut/report.html"));
    }

    void expect_nothing_half_written() const {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "cut")) {
            EXPECT_EQ(entry.path().filename().string().find(".partial"), std::string::npos) << entry.path();
        }
    }

    void expect_to_go_on_to_the_same_bits() {
        const ProgramResult resumed = run_suffuse({"resume", "cut"});
        ASSERT_EQ(resumed.code, 0) << resumed.error;
        static const std::string whole = hash_of_a_whole_run();
        EXPECT_EQ(hash_in("cut"), whole);
    }

    std::string hash_of_a_whole_run() {
        EXPECT_EQ(run_suffuse({"run", "soil/case.toml", "-o", "whole", "--no-cache"}).code, 0);
        return hash_in("whole");
    }

    [[nodiscard]] std::string hash_in(const std::string& run) const {
        return nlohmann::json::parse(read_all(folder / (run + "/studies/replay/compressed/stage.json")))
            .at("state_hash");
    }
};

/// Both ends of a pipe.
class TestPipe {
public:
    TestPipe() { EXPECT_EQ(pipe2(ends_.data(), O_CLOEXEC), 0); }

    ~TestPipe() {
        close_end(0);
        close_end(1);
    }

    TestPipe(const TestPipe&) = delete;
    TestPipe& operator=(const TestPipe&) = delete;

    void close_end(std::size_t end) {
        if (ends_[end] >= 0) {
            close(std::exchange(ends_[end], -1));
        }
    }

    [[nodiscard]] int reading() const { return ends_[0]; }

    [[nodiscard]] int writing() const { return ends_[1]; }

private:
    std::array<int, 2> ends_{-1, -1};
};

/// A terminal: what stands at its other end is this test.
class Terminal {
public:
    Terminal() : descriptor_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        EXPECT_TRUE(descriptor_ >= 0 && grantpt(descriptor_) == 0 && unlockpt(descriptor_) == 0);
        name_ = ptsname(descriptor_);
    }

    ~Terminal() { close_it(); }

    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    /// Makes the process the leader of a session at this terminal.
    void sit_down() const {
        setsid();
        const int screen = open(name_.c_str(), O_RDWR);
        ioctl(screen, TIOCSCTTY, 0);
        for (const int descriptor : {0, 1, 2}) {
            dup2(screen, descriptor);
        }
        close(screen);
    }

    /// As Ctrl-S does.
    void hold_up() const {
        const int screen = open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        EXPECT_EQ(tcflow(screen, TCOOFF), 0);
        close(screen);
    }

    void close_it() {
        if (descriptor_ >= 0) {
            close(std::exchange(descriptor_, -1));
        }
    }

private:
    int descriptor_;
    std::string name_;
};

TEST_F(Stopping, ATerminalThatClosesSavesTheRun) {
    Terminal terminal;
    HeldRun run = start_run([&] { terminal.sit_down(); });
    terminal.close_it(); // the kernel sends SIGHUP, and every word from now on fails
    run.let_go();
    EXPECT_EQ(wait_for(run.child).code, 129);
    expect_saved();
    expect_to_go_on_to_the_same_bits();
}

TEST_F(Stopping, AShellThatEndsWithItsTerminalTakesNoWorkAlong) {
    Terminal terminal;
    TestPipe life; // of the run, which is no child of ours
    HeldRun shell = start_run([&] {
        terminal.sit_down();
        dup(life.writing());
        const char* const line = SUFFUSE_PROGRAM " run soil/case.toml -o cut -j 1 --no-cache; :";
        execl("/bin/sh", "sh", "-c", line, static_cast<char*>(nullptr));
    });
    life.close_end(1);
    terminal.close_it();
    EXPECT_EQ(wait_for(shell.child).code, -SIGHUP); // by then its jobs have their SIGHUP too
    shell.let_go();
    wait_until("the run ends", [&] {
        pollfd request{life.reading(), POLLIN, 0};
        return poll(&request, 1, 0) > 0 && (request.revents & POLLHUP) != 0;
    });
    expect_saved();
    expect_to_go_on_to_the_same_bits();
}

TEST_F(Stopping, CtrlCSavesTheRunThoughTeeDiesOfItFirst) {
    TestPipe pipe;
    const pid_t tee = fork();
    if (tee == 0) {
        take_signals();
        setpgid(0, 0);
        dup2(pipe.reading(), 0);
        pipe.close_end(1);
        execlp("tee", "tee", (folder / "log").c_str(), static_cast<char*>(nullptr));
        _exit(98);
    }
    setpgid(tee, tee);
    HeldRun run = start_run([&] {
        setpgid(0, tee);
        dup2(pipe.writing(), 1);
        dup2(pipe.writing(), 2);
    });
    pipe.close_end(0);
    pipe.close_end(1);
    wait_until("tee works", [&] { return read_all(folder / "log").find("plan  ") != std::string::npos; });
    kill(-tee, SIGINT);
    EXPECT_EQ(wait_for(tee).code, -SIGINT);
    run.let_go(); // its farewell finds nobody
    EXPECT_EQ(wait_for(run.child).code, 130);
    expect_saved();
    expect_to_go_on_to_the_same_bits();
}

TEST_F(Stopping, BatchSystemsMayGiveSignalsAsOftenAsTheyLike) {
    struct Course {
        std::vector<int> signals;
        int code;
    };

    for (const Course& course : std::vector<Course>{
             {{SIGTERM, SIGCONT, SIGTERM}, 143}, // Slurm: its warning, then its end
             {{SIGUSR1, SIGCONT, SIGTERM}, 138},
             {{SIGUSR2, SIGINT, SIGTERM}, 140}, // LSF
             {{SIGXCPU, SIGXCPU}, 152},         // the kernel, each second
             {{SIGHUP, SIGHUP}, 129},           // a shell and the kernel
             {{SIGINT, SIGHUP, SIGTERM}, 130},  // somebody who presses Ctrl-C and closes the window
         }) {
        std::filesystem::remove_all(folder / "cut");
        HeldRun run = start_run();
        kill(run.child, course.signals.front());
        wait_until("the first signal is handled", [&] {
            return read_all(folder / "error").find("stopping;") != std::string::npos;
        });
        for (std::size_t k = 1; k < course.signals.size(); ++k) {
            kill(run.child, course.signals[k]);
        }
        run.let_go();
        const ProgramResult result = wait_for(run.child);
        EXPECT_EQ(result.code, course.code) << result.error;
        expect_saved();
    }
    expect_to_go_on_to_the_same_bits();
}

TEST_F(Stopping, UnderNohupARunOutlivesItsTerminal) {
    HeldRun run = start_run([] { std::signal(SIGHUP, SIG_IGN); });
    kill(run.child, SIGHUP);
    run.let_go();
    const ProgramResult result = wait_for(run.child);
    EXPECT_EQ(result.code, 0) << result.error;
    EXPECT_EQ(result.error.find("stopping"), std::string::npos) << result.error;
}

TEST_F(Stopping, ARunThatNobodyListensToEndsAsAnyOther) {
    for (const bool json : {false, true}) {
        TestPipe pipe;
        pipe.close_end(0);
        std::vector<std::string> words = {"run", "soil/case.toml", "-o", json ? "json" : "quiet"};
        if (json) {
            words.emplace_back("--json");
        }
        const ProgramResult result = wait_for(start(words, {}, [&] {
            dup2(pipe.writing(), 1);
            dup2(pipe.writing(), 2);
        }));
        EXPECT_EQ(result.code, 0);
        EXPECT_EQ(run_suffuse({"verify", words[3]}).code, 0);
    }
}

TEST_F(Stopping, ATerminalThatIsHeldUpKeepsNoRunFromSaving) {
    Terminal terminal;
    HeldRun run = start_run([&] { terminal.sit_down(); });
    terminal.hold_up();
    kill(run.child, SIGTERM);
    run.let_go();
    wait_until("the stage is saved", [&] { return std::filesystem::exists(stage("partial.h5")); });
    terminal.close_it(); // only its last words have waited
    EXPECT_EQ(wait_for(run.child).code, 143);
    expect_saved();
}

TEST_F(Stopping, AFileBeyondTheLimitIsCode74WithItsNameAndAdvice) {
    const auto limit = [] {
        const rlimit bytes{100'000, RLIM_INFINITY};
        setrlimit(RLIMIT_FSIZE, &bytes);
    };
    const ProgramResult result = wait_for(start(cut_run, {}, limit));
    EXPECT_EQ(result.code, 74) << result.error;
    expect_in("cut/studies/replay/start/state.h5: File too large; raise the limit on the size of files", result.error);
    expect_nothing_half_written();
    expect_to_go_on_to_the_same_bits();
}

TEST_F(Stopping, ARunWhoseFolderWasMovedSaysSoAndGoesOnWhereItLies) {
    HeldRun run = start_run();
    std::filesystem::rename(folder / "cut", folder / "moved");
    run.let_go();
    const ProgramResult result = wait_for(run.child);
    EXPECT_EQ(result.code, 74) << result.error;
    expect_in("cut: was moved or removed while the run worked in it", result.error);
    EXPECT_FALSE(std::filesystem::exists(folder / "cut")) << "half a run in two places";
    ASSERT_EQ(run_suffuse({"resume", "moved"}).code, 0);
    EXPECT_EQ(hash_in("moved"), hash_of_a_whole_run());
}

TEST_F(Stopping, AReaderWhoHasEnoughIsNoError) {
    TestPipe pipe;
    pipe.close_end(0);
    const ProgramResult result = wait_for(start({"schema"}, {}, [&] { dup2(pipe.writing(), 1); }));
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.error, "");
}

TEST_F(Stopping, AWatchEndsWhenItsReaderHasEnoughAndTheRunGoesOn) {
    HeldRun run = start_run();
    TestPipe pipe;
    const pid_t watch = start({"watch", "cut"}, {}, [&] { dup2(pipe.writing(), 1); });
    char first = 0;
    EXPECT_EQ(read(pipe.reading(), &first, 1), 1);
    pipe.close_end(0);
    const ProgramResult result = wait_for(watch);
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.error, "");
    run.let_go();
    EXPECT_EQ(wait_for(run.child).code, 0);
}

} // namespace
} // namespace suffuse
