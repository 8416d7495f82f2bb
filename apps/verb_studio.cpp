// studio: a local page for soils, cases and runs, for people who do not use terminals.

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/job/run_folder.hpp"

#include <fmt/format.h>

#include "apps/browser.hpp"
#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/studio/program.hpp"
#include "apps/studio/run_folders.hpp"
#include "apps/studio/server.hpp"
#include "apps/templates.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

constexpr int first_port = 8610, ports_to_try = 50;

struct StudioVerb final : Verb {
    StudioVerb()
        : Verb(
              "studio", "open a page for soils, runs and reports in the browser", "suffuse studio my-dam --port 8700"
          ) {}

    std::string folder;
    std::optional<std::int64_t> port;
    bool has_no_browser = false, saves_runs = false;

    void add_to(Options& options) override {
        options.argument("FOLDER", folder, "that holds runs, or will; runs unless given");
        options.value("--port", port, "of this machine; 8610 or the next free one unless given")
            .type("N")
            .whole_number(1024, 65'535);
        options.flag("--no-browser", has_no_browser, "only print the address");
        options.flag("--save-runs", saves_runs, "Ctrl-C also saves and stops the runs at work; otherwise they go on");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

/// A free port, and the server bound to it. @throws UsageError where the requested one is taken.
void bind(studio::Server& server, const std::optional<std::int64_t>& requested, const Console& console) {
    const int first = static_cast<int>(requested.value_or(first_port));
    if (server.bind(first)) {
        return;
    }
    for (int port = first + 1; port < first + ports_to_try && port < 65'536; ++port) {
        if (!server.bind(port)) {
            continue;
        }
        if (requested) {
            throw UsageError(fmt::format("port {} is taken; the next free one is --port {}", first, port));
        }
        console.talk(fmt::format("port {} is taken, perhaps by another studio; this one takes {}", first, port));
        return;
    }
    throw UsageError(fmt::format("port {} and those after it are taken; choose another one by --port N", first));
}

/// Opens a page of this user alone that leads to the address: other users can read the words of a command, and the
/// address holds the token.
void show_address(const std::string& address, const fs::path& private_folder) {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
        return;
    }
    const fs::path page = private_folder / "studio.html";
    io::write_file(
        page, "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>suffuse studio</title>"
              "<meta http-equiv=\"refresh\" content=\"0;url=" +
                  address + "\"><p><a href=\"" + address + "\">suffuse studio</a></p>"
    );
    std::thread([page] { open_in_browser(page.string()); }).detach(); // some browsers return when they are closed
}

/// Tells what goes on, or saves and stops it.
void leave_runs(const fs::path& folder, bool saves, const Console& console) {
    for (const fs::path& run : studio::runs_at_work(folder)) {
        const std::string name = shell_word((folder / run.filename()).string());
        const std::optional<pid_t> process = saves ? studio::process_of(run) : std::nullopt;
        if (!process) {
            console.talk(fmt::format("still at work: suffuse watch {}", name));
            continue;
        }
        kill(*process, SIGTERM);
        while (job::is_at_work(run)) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        console.talk(fmt::format("saved; resume with: suffuse resume {}", name));
    }
}

int StudioVerb::act(const CommandLine&, const Console& console) const {
    const fs::path page = page_folder(), runs = folder.empty() ? "runs" : folder;
    if (!fs::exists(page / "studio.html")) {
        throw IoError("the studio's page was not built: install Node (18 or newer) and npm, and call ./run studio");
    }
    if (fs::exists(runs) && !fs::is_directory(runs)) {
        throw UsageError(fmt::format("{} is a file; studio needs a folder", runs.string()));
    }
    io::make_folders(runs);
    sigset_t ends;
    sigemptyset(&ends);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&ends, signal);
    }
    pthread_sigmask(SIG_BLOCK, &ends, nullptr); // before any thread: this one alone waits for them
    studio::Server server(runs, page, template_names());
    bind(server, port, console);
    server.start();
    console.result(server.address());
    console.document(json_text({{"address", server.address()}, {"folder", runs.string()}}));
    console.finish();
    console.talk("open this address in a browser of this machine; Ctrl-C ends the studio");
    const studio::ScratchFolder private_folder;
    if (!has_no_browser) {
        show_address(server.address(), private_folder.path());
    }
    int signal = 0;
    sigwait(&ends, &signal);
    pthread_sigmask(SIG_UNBLOCK, &ends, nullptr); // a second Ctrl-C waits for nothing
    server.stop();
    leave_runs(runs, saves_runs, console);
    return Done;
}

} // namespace

MadeVerb make_studio_verb() {
    return std::make_unique<StudioVerb>();
}

} // namespace suffuse::apps
