#include "apps/studio/program.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace suffuse::studio {
namespace {

namespace fs = std::filesystem;

struct Streams {
    fs::path out, error;
    int flags = O_WRONLY | O_CREAT | O_TRUNC; // not O_CLOEXEC: it would close them for the program, too
};

/// A child without this server's sockets, with the usual signals. @throws IoError
pid_t spawn(const std::vector<std::string>& words, const fs::path& folder, const Streams& streams, bool own_session) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, streams.out.c_str(), streams.flags, 0666);
    if (streams.error == streams.out) {
        posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    } else {
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, streams.error.c_str(), streams.flags, 0666);
    }
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    sigset_t none, usual;
    sigemptyset(&none);
    sigfillset(&usual);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(
        &attributes,
        static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | (own_session ? POSIX_SPAWN_SETSID : 0))
    );
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 2);
    arguments.push_back(const_cast<char*>("suffuse"));
    for (const std::string& word : words) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int error = posix_spawn(&child, "/proc/self/exe", &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) {
        throw IoError(fmt::format("suffuse {} cannot be started: {}", words.front(), std::strerror(error)));
    }
    return child;
}

int wait_within(pid_t child, std::chrono::seconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > end) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

} // namespace

ProgramCall call_program(const std::vector<std::string>& words, const fs::path& folder, std::chrono::seconds limit) {
    const ScratchFolder streams;
    const fs::path out = streams.path() / "out", error = streams.path() / "error";
    std::vector<std::string> all = words;
    all.emplace_back("--json");
    ProgramCall call;
    call.code = wait_within(spawn(all, folder, {out, error}, false), limit);
    call.document = nlohmann::json::parse(read_whole_file(out.string()), nullptr, false);
    if (call.document.is_discarded()) {
        call.document = nullptr;
    }
    std::istringstream lines(read_whole_file(error.string()));
    for (std::string line; std::getline(lines, line);) {
        call.talk.push_back(as_utf8(line));
    }
    return call;
}

pid_t start_program(const std::vector<std::string>& words, const fs::path& folder, const fs::path& log) {
    return spawn(words, folder, {log, log, O_WRONLY | O_CREAT | O_APPEND}, true);
}

ScratchFolder::ScratchFolder() {
    std::string pattern = (fs::temp_directory_path() / "suffuse-studio-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
        throw IoError(fmt::format("{}: cannot be made: {}", pattern, std::strerror(errno)));
    }
    path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

} // namespace suffuse::studio
