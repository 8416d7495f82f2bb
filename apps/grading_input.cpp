#include "apps/grading_input.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <memory>
#include <vector>

namespace suffuse::apps {
namespace {

std::shared_ptr<const Source> source_of(const std::string& path) {
    if (path != "-") {
        return std::make_shared<Source>(Source{path, read_whole_file(path)});
    }
    const std::string name = "standard input";
    return std::make_shared<Source>(Source{name, read_whole_stream(stdin, name)});
}

} // namespace

gradings::GradingFile read_gradings_of(const std::string& path, const std::string& sample) {
    return gradings::read_gradings(source_of(path), gradings::CurveEnds::MayBeOpen, sample);
}

gradings::GradingFile read_one_grading(const std::string& path, const std::string& sample) {
    gradings::GradingFile file = read_gradings_of(path, sample);
    if (file.soils.size() > 1) {
        constexpr std::size_t most = 12;
        std::vector<std::string> names;
        for (const gradings::NamedGrading& soil : file.soils) {
            names.push_back(soil.name);
        }
        const std::size_t more = names.size() - std::min(most, names.size());
        names.resize(names.size() - more);
        throw CaseError(fmt::format(
            "{} holds {} samples, and one is needed: {}{}; choose it by --sample NAME", path, file.soils.size(),
            fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : ""
        ));
    }
    return file;
}

std::string remark_text(const Diagnostic& remark) {
    const std::string place = remark.line > 0 ? fmt::format("{}:{}", remark.file, remark.line) : remark.file;
    return fmt::format("{}: {}{}{}", place, remark.message, remark.help.empty() ? "" : "; ", remark.help);
}

void print_remarks(const gradings::GradingFile& file, const Console& console) {
    for (const Diagnostic& remark : file.remarks) {
        console.talk(remark_text(remark));
    }
}

} // namespace suffuse::apps
