#include "suffuse/job/other_program.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/memory_bound.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace suffuse::job {
namespace {

constexpr std::size_t longest_complaint = 2000;

/// Both ends of a pipe, closed when it goes out of scope.
struct Pipe {
    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            throw IoError(fmt::format("no pipe to another program: {}", std::strerror(errno)));
        }
    }

    ~Pipe() {
        close_end(0);
        close_end(1);
    }

    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    void close_end(std::size_t k) {
        if (ends[k] >= 0) {
            close(ends[k]);
            ends[k] = -1;
        }
    }

    std::array<int, 2> ends{-1, -1};
};

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> part{};
    for (;;) {
        const ssize_t count = read(descriptor, part.data(), part.size());
        if (count > 0) {
            text.append(part.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || errno != EINTR) {
            break;
        }
    }
    while (!text.empty() && text.back() == '\n') {
        text.pop_back();
    }
    return text.size() > longest_complaint ? text.substr(text.size() - longest_complaint) : text;
}

} // namespace

bool is_installed(const std::string& name) {
    const char* path = std::getenv("PATH");
    const std::string folders = path != nullptr ? path : "/usr/bin:/bin";
    for (std::size_t begin = 0; begin <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', begin), folders.size());
        if (end > begin && access((folders.substr(begin, end - begin) + "/" + name).c_str(), X_OK) == 0) {
            return true;
        }
        begin = end + 1;
    }
    return false;
}

ProgramEnd run_program(const std::vector<std::string>& words) {
    expects(!words.empty(), "a program has a name");
    Pipe complaints;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, complaints.ends[1], STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str())); // as posix_spawn wants it; nobody writes there
    }
    arguments.push_back(nullptr);
    pid_t child = 0;
    const double bound = bound_memory(std::numeric_limits<double>::infinity()); // ours, not the other program's
    const int problem = posix_spawnp(&child, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
    bound_memory(bound);
    posix_spawn_file_actions_destroy(&actions);
    if (problem != 0) {
        throw IoError(fmt::format("{} cannot be started: {}", words[0], std::strerror(problem)));
    }
    complaints.close_end(1);
    ProgramEnd end;
    end.complaint = read_all(complaints.ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    end.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return end;
}

} // namespace suffuse::job
