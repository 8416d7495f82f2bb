#include "apps/studio/server.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>

#include "apps/studio/door.hpp"
#include "apps/studio/routes.hpp"
#include <array>
#include <chrono>
#include <exception>
#include <optional>
#include <thread>
#include <utility>

namespace suffuse::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t requests_at_once = 16;

struct PageFile {
    const char *path, *file, *type;
};

constexpr std::array<PageFile, 3> page_files = {{
    {"/", "studio.html", "text/html; charset=utf-8"},
    {"/studio.js", "studio.js", "text/javascript; charset=utf-8"},
    {"/studio.css", "studio.css", "text/css; charset=utf-8"},
}};

void answer_exception(httplib::Response& response, const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const Refusal& refusal) {
        refuse(response, refusal.status, refusal.what());
    } catch (const Error& error) {
        refuse(response, 422, error.what());
    } catch (const fs::filesystem_error& error) {
        refuse(
            response, 500,
            fmt::format(
                "{}: {}; if the folder was moved or removed, end the studio and start it again", error.path1().string(),
                error.code().message()
            )
        );
    } catch (const std::exception& error) {
        refuse(response, 500, error.what());
    }
}

/// Without SO_REUSEPORT, which the library sets: two servers would share a port, and take turns in answering.
void set_socket_options(socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

} // namespace

struct Server::Parts {
    Studio studio;
    httplib::Server server;
    std::optional<Door> door;
    std::thread thread;
};

Server::Server(const fs::path& folder, const fs::path& page, std::vector<std::string> examples)
    : parts_(std::make_unique<Parts>()) {
    Parts& parts = *parts_;
    parts.studio.folder = fs::canonical(folder);
    parts.studio.examples = std::move(examples);
    httplib::Server& server = parts.server;
    server.new_task_queue = [] { return new httplib::ThreadPool(requests_at_once); };
    server.set_socket_options(set_socket_options);
    server.set_keep_alive_max_count(1); // a kept connection would keep one of the threads
    server.set_payload_max_length(most_upload);
    server.set_default_headers(common_headers());
    server.set_pre_routing_handler([&parts](const httplib::Request& request, httplib::Response& response) {
        return parts.door->answers(request, response) ? httplib::Server::HandlerResponse::Handled
                                                      : httplib::Server::HandlerResponse::Unhandled;
    });
    server.set_exception_handler([](const httplib::Request&, httplib::Response& response,
                                    const std::exception_ptr& thrown) { answer_exception(response, thrown); });
    server.set_error_handler([](const httplib::Request&, httplib::Response& response) {
        if (response.body.empty()) {
            refuse(response, response.status, response.status == 404 ? "nothing is here" : "this cannot be answered");
        }
    });
    for (const PageFile& file : page_files) {
        server.Get(file.path, [file, page](const httplib::Request&, httplib::Response& response) {
            response.set_header("Content-Security-Policy", own_policy);
            response.set_header("Cross-Origin-Opener-Policy", "same-origin"); // browsers refuse it on what is sandboxed
            set_plain_content(response, read_whole_file((page / file.file).string()), file.type);
        });
    }
    add_soil_routes(server);
    add_case_routes(server, parts.studio);
    add_run_routes(server, parts.studio);
    add_sweep_routes(server, parts.studio);
}

Server::~Server() {
    stop();
}

bool Server::bind(int port) {
    if (!parts_->server.bind_to_port("127.0.0.1", port)) {
        return false;
    }
    parts_->door.emplace(port);
    return true;
}

std::string Server::address() const {
    return parts_->door->address();
}

void Server::start() {
    parts_->thread = std::thread([this] { parts_->server.listen_after_bind(); });
    while (!parts_->server.is_running()) { // before that it cannot be stopped
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

void Server::stop() {
    if (parts_->thread.joinable()) {
        parts_->server.stop();
        parts_->thread.join();
    }
}

} // namespace suffuse::studio
