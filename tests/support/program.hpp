#pragma once
// The program as a user calls it, in a folder of its own: what its tests share.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/reference.hpp"
#include "tests/support/temp_folder.hpp"
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace suffuse::test {

inline const std::string examples = in_checkout("examples/");

struct ProgramResult {
    int code = -1; ///< minus the signal where one ended it
    std::string out, error;

    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

inline void write_to(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what << " is not in the text";
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

/// @throws what was waited for, where it takes longer than any load could make it.
template <class Condition>
void wait_until(const std::string& what, Condition is_true) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!is_true()) {
        if (std::chrono::steady_clock::now() > limit) {
            throw std::runtime_error("waited two minutes in vain: " + what);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

/// In a child: signals do what they usually do, however the tests were started; by nohup, say, or in the background.
inline void take_signals() {
    for (const int signal : {SIGHUP, SIGINT, SIGTERM, SIGPIPE, SIGXFSZ}) {
        std::signal(signal, SIG_DFL);
    }
}

inline int wait_status(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// A run that waits in the middle of a stage (apps/test_gate.hpp) until it is let go: what is sent to it meanwhile
/// finds it there, whatever the load. It does not outlive this.
class HeldRun {
public:
    HeldRun(pid_t program, const std::filesystem::path& fifo) : child(program) {
        wait_until("the run comes to its gate", [&] {
            descriptor_ = open(fifo.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC); // as soon as the run reads there
            return descriptor_ >= 0 || !is_running();
        });
        if (descriptor_ < 0) {
            throw std::runtime_error("the run ended before it came to its gate");
        }
    }

    ~HeldRun() {
        if (is_running()) {
            kill(child, SIGKILL);
            wait_status(child);
        }
        let_go();
    }

    HeldRun(const HeldRun&) = delete;
    HeldRun& operator=(const HeldRun&) = delete;

    void let_go() {
        if (descriptor_ >= 0) {
            close(std::exchange(descriptor_, -1));
        }
    }

    const pid_t child;

private:
    [[nodiscard]] bool is_running() const {
        siginfo_t ended{};
        return waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid == 0;
    }

    int descriptor_ = -1;
};

/// A folder to work in, and the program in it.
class Cli : public testing::Test {
protected:
    /// @param in_child what else the child does before it becomes the program
    pid_t start(
        const std::vector<std::string>& words, const std::vector<std::string>& environment = {},
        const std::function<void()>& in_child = {}
    ) {
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
        prctl(PR_SET_PDEATHSIG, SIGKILL); // a test that is killed leaves no run behind that waits for it
        take_signals();
        for (const std::string& variable : environment) {
            putenv(const_cast<char*>(variable.c_str()));
        }
        if (in_child) {
            in_child();
        }
        std::vector<char*> arguments{const_cast<char*>("suffuse")};
        for (const std::string& word : words) {
            arguments.push_back(const_cast<char*>(word.c_str()));
        }
        arguments.push_back(nullptr);
        execv(SUFFUSE_PROGRAM, arguments.data());
        _exit(98);
    }

    /// The same, in the middle of a stage: "study/stage".
    HeldRun start_held(
        const std::string& stage, const std::vector<std::string>& words,
        const std::vector<std::string>& environment = {}, const std::function<void()>& in_child = {}
    ) {
        const std::filesystem::path fifo = folder / ("gate-" + std::to_string(++gates_));
        EXPECT_EQ(mkfifo(fifo.c_str(), 0600), 0);
        std::vector<std::string> all = environment;
        all.push_back("SUFFUSE_TEST_GATE=" + stage + "=" + fifo.string());
        return {start(words, all, in_child), fifo};
    }

    ProgramResult wait_for(pid_t child) {
        const int status = wait_status(child);
        return {
            WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read_all(folder / "out"),
            read_all(folder / "error")};
    }

    ProgramResult run_suffuse(const std::vector<std::string>& words, const std::vector<std::string>& environment = {}) {
        return wait_for(start(words, environment));
    }

    /// The replay example with one text replaced; the message of `check` and its code.
    ProgramResult check_with(const std::string& what, const std::string& with) {
        write_to(folder / "case.toml", replaced(read_all(examples + "replay/case.toml"), what, with));
        write_to(folder / "packing.csv", read_all(examples + "replay/packing.csv"));
        return run_suffuse({"check", "case.toml"});
    }

    TempFolder folder;

private:
    int gates_ = 0;
};

/// The same, in tests that draw charts: skipped where npm has not built the report's page.
template <class Fixture>
class Drawing : public Fixture {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(
                std::filesystem::path(SUFFUSE_PROGRAM).parent_path() / "../../report-page/figures.mjs"
            )) {
            GTEST_SKIP() << "npm has not built the report's page; ./test does";
        }
        Fixture::SetUp();
    }
};

inline void expect_in(const std::string& part, const std::string& text) {
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}

} // namespace suffuse::test
