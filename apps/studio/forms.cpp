// Forms of the page -> words of the command line and files; what the program said -> an answer.

#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/studio/routes.hpp"
#include <algorithm>
#include <cctype>
#include <regex>

namespace suffuse::studio {

std::string field(const httplib::Request& request, const std::string& name) {
    return request.has_file(name) ? request.get_file_value(name).content : "";
}

void add_options(
    const httplib::Request& request, const std::vector<std::string_view>& names, std::vector<std::string>& words
) {
    for (const std::string_view name : names) {
        if (const std::string value = field(request, std::string(name)); !value.empty()) {
            words.push_back(fmt::format("--{}={}", name, value));
        }
    }
}

std::string take_upload(const httplib::Request& request, const std::string& name, const std::filesystem::path& folder) {
    if (!request.has_file(name)) {
        throw Refusal(400, fmt::format("the request has no file `{}`", name));
    }
    constexpr std::size_t most = 80;
    const httplib::MultipartFormData& upload = request.get_file_value(name);
    std::string safe = upload.filename.substr(0, most);
    std::ranges::replace_if(
        safe, [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '_' && c != '-'; }, '-'
    );
    if (safe.empty() || safe.front() == '.' || safe.front() == '-' || safe.ends_with(".toml")) {
        safe = name + "-" + safe + ".csv"; // no option, no hidden file, and no case
    }
    std::filesystem::create_directories(folder / name);
    io::write_file(folder / name / safe, upload.content);
    return (std::filesystem::path(name) / safe).string();
}

void take_case(const httplib::Request& request, const std::filesystem::path& folder) {
    static const std::regex plain("([A-Za-z0-9_][A-Za-z0-9._-]*/)?[A-Za-z0-9_][A-Za-z0-9._-]*");
    const std::string mark = "file:";
    io::write_file(folder / "case.toml", field(request, "case"));
    for (const auto& [name, part] : request.files) {
        if (!name.starts_with(mark)) {
            continue;
        }
        const std::string path = name.substr(mark.size());
        if (!std::regex_match(path, plain)) {
            throw Refusal(400, "a file of a case is called like data/dam.csv");
        }
        io::make_folders((folder / path).parent_path());
        io::write_file(folder / path, part.content);
    }
}

namespace {

/// The HTTP status that fits an exit code.
int status_of(const ProgramCall& call) {
    constexpr int wrong_use = 2, bad_case = 3;
    if (call.code == 0) {
        return 200;
    }
    return call.code == wrong_use || call.code == bad_case ? 422 : 500;
}

} // namespace

void answer_call(httplib::Response& response, const ProgramCall& call) {
    nlohmann::json document{{"talk", call.talk}};
    if (call.code == 0) {
        document["result"] = call.document;
    } else if (call.document.is_object() && call.document.contains("error")) {
        document["error"] = call.document["error"];
    } else {
        const std::string text = fmt::format("{}", fmt::join(call.talk, "\n"));
        document["error"] = {{"message", text.empty() ? fmt::format("the program ended with {}", call.code) : text}};
    }
    answer(response, status_of(call), document);
}

} // namespace suffuse::studio
