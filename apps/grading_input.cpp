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

void ReadingFlags::add_to(Options& options, const std::string& group) {
    options.value("--size", size, "column of the sizes: its heading or number, and its unit")
        .type("COLUMN[:UNIT]")
        .of_group(group);
    options.value("--passing", passing, "column of percent passing").type("COLUMN[:UNIT]").of_group(group);
    options.value("--retained", retained, "column of cumulative percent retained")
        .type("COLUMN[:UNIT]")
        .of_group(group);
    options.value("--share", share, "column of what each sieve alone retains").type("COLUMN[:UNIT]").of_group(group);
    options.value("--mass", mass, "column of the mass on each sieve").type("COLUMN[:UNIT]").of_group(group);
    options.value("--by", by, "shares are of the mass or of the number of grains")
        .type("WHAT")
        .of_group(group)
        .one_of({"mass", "number"});
    options.value("--sheet", sheet, "the table of a file with several, from 1")
        .type("N")
        .of_group(group)
        .whole_number(1, 10'000);
    options.value("--rows", rows, "first and last line of the table in the file").type("A-B").of_group(group);
}

gradings::GradingFile
read_gradings_of(const std::string& path, const std::string& sample, const gradings::ReadingOptions& options) {
    return gradings::read_gradings(source_of(path), gradings::CurveEnds::MayBeOpen, sample, options);
}

std::string shown_reading(const gradings::GradingFile& file) {
    std::string text;
    for (const gradings::NamedGrading& soil : file.soils) {
        text += fmt::format(
            "{}{}{}\n", text.empty() ? "" : "\n", soil.name.empty() ? "" : soil.name + "\n", words_of(soil.reading)
        );
        for (std::size_t k = 0; k < soil.grading.diameter.size(); ++k) {
            text += fmt::format(
                "{:>12.6g} mm {:>10.6g} %\n", 1e3 * soil.grading.diameter[k], 100 * soil.grading.passing[k]
            );
        }
    }
    text.pop_back();
    return text;
}

gradings::GradingFile read_one_grading(
    const std::string& path, const std::string& sample, const gradings::ReadingOptions& options, const char* flag
) {
    gradings::GradingFile file = read_gradings_of(path, sample, options);
    if (file.soils.size() > 1) {
        constexpr std::size_t most = 12;
        std::vector<std::string> names;
        for (const gradings::NamedGrading& soil : file.soils) {
            names.push_back(soil.name);
        }
        const std::size_t more = names.size() - std::min(most, names.size());
        names.resize(names.size() - more);
        throw CaseError(fmt::format(
            "{} holds {} samples, and one is needed: {}{}; choose it by {} NAME", path, file.soils.size(),
            fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "", flag
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
