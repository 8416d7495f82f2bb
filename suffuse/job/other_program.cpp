#include "suffuse/job/other_program.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/memory_bound.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

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
    return text;
}

/// In the child: becomes the other program, which ends with the thread that waits for it, however that ends.
/// @param kept STDOUT_FILENO or STDERR_FILENO, which goes into the pipe; the other one is dropped
/// @return why it could not
int become(char* const* words, int pipe, int kept, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) { // has ended already
        return ECHILD;
    }
    const int input = open("/dev/null", O_RDONLY), output = open("/dev/null", O_WRONLY);
    const int dropped = kept == STDOUT_FILENO ? STDERR_FILENO : STDOUT_FILENO;
    if (input < 0 || output < 0 || dup2(input, STDIN_FILENO) < 0 || dup2(output, dropped) < 0 || dup2(pipe, kept) < 0) {
        return errno;
    }
    for (const int descriptor : {input, output}) {
        if (descriptor > STDERR_FILENO) {
            close(descriptor);
        }
    }
    execvp(words[0], words);
    return errno;
}

/// @throws IoError where it cannot be started
pid_t start(char* const* words, int pipe, int kept) {
    Pipe problem;                                                               // closed by what starts
    const double bound = bound_memory(std::numeric_limits<double>::infinity()); // ours, not the other program's
    const pid_t parent = getpid(), child = fork();
    if (child == 0) { // from here on only calls that a signal handler may make, too: other threads may hold locks
        const int code = become(words, pipe, kept, parent);
        static_cast<void>(!write(problem.ends[1], &code, sizeof code));
        _exit(127);
    }
    int code = child < 0 ? errno : 0;
    bound_memory(bound);
    problem.close_end(1);
    if (child > 0 && read(problem.ends[0], &code, sizeof code) == static_cast<ssize_t>(sizeof code)) {
        waitpid(child, nullptr, 0);
    }
    if (code != 0) {
        throw IoError(fmt::format("{} cannot be started: {}", words[0], std::strerror(code)));
    }
    return child;
}

/// Runs it to its end; the text that is kept is in `complaint`.
ProgramEnd run_keeping(const std::vector<std::string>& words, int kept) {
    expects(!words.empty(), "a program has a name");
    Pipe pipe;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str())); // as execvp wants it; nobody writes there
    }
    arguments.push_back(nullptr);
    const pid_t child = start(arguments.data(), pipe.ends[1], kept);
    pipe.close_end(1);
    ProgramEnd end;
    end.complaint = read_all(pipe.ends[0]);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    end.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return end;
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
    ProgramEnd end = run_keeping(words, STDERR_FILENO);
    if (end.complaint.size() > longest_complaint) {
        end.complaint.erase(0, end.complaint.size() - longest_complaint);
    }
    return end;
}

std::optional<std::string> output_of(const std::vector<std::string>& words) {
    if (!is_installed(words.front())) {
        return std::nullopt;
    }
    ProgramEnd end = run_keeping(words, STDOUT_FILENO);
    return end.code == 0 ? std::optional(std::move(end.complaint)) : std::nullopt;
}

} // namespace suffuse::job
