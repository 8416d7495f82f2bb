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
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace suffuse::test {

inline const std::string examples = in_checkout("examples/");

struct Said {
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

inline void expect_in(const std::string& part, const std::string& text) {
    EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}

} // namespace suffuse::test
