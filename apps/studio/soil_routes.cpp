// A soil's curve: how it is read, and what the criteria and the atlas say of it, by `suffuse assess`.

#include "apps/studio/routes.hpp"

namespace suffuse::studio {
namespace {

const std::vector<std::string_view> reading_options = {"sample", "size", "passing", "retained", "share",
                                                       "mass",   "by",   "sheet",   "rows"};

void show_reading(const httplib::Request& request, httplib::Response& response) {
    const ScratchFolder folder;
    std::vector<std::string> words{"assess", take_upload(request, "curve", folder.path()), "--show-reading"};
    add_options(request, reading_options, words);
    answer_call(response, call_program(words, folder.path()));
}

void assess(const httplib::Request& request, httplib::Response& response) {
    const ScratchFolder folder;
    std::vector<std::string> words{"assess", take_upload(request, "curve", folder.path())};
    add_options(request, reading_options, words);
    add_options(request, {"fines", "gradient", "flow", "relative-density", "porosity", "density", "alpha"}, words);
    if (request.has_file("filter")) {
        words.push_back("--filter=" + take_upload(request, "filter", folder.path()));
        add_options(request, {"filter-sample"}, words);
    }
    answer_call(response, call_program(words, folder.path()));
}

} // namespace

void add_soil_routes(httplib::Server& server) {
    server.Post("/api/reading", show_reading);
    server.Post("/api/assess", assess);
}

} // namespace suffuse::studio
