#include "suffuse/gradings/read_grading.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/ags_grading.hpp"
#include "suffuse/gradings/align_rows.hpp"
#include "suffuse/gradings/grading_tables.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/sheet_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace suffuse::gradings {

namespace {

/// What a sheet says when its columns stand between one mark.
struct Reading {
    Sheet sheet;
    std::vector<SheetTable> tables; ///< of the sheet, with their columns; empty where one has none
    Problems problems;
};

Reading try_mark(const std::shared_ptr<const Source>& source, char mark) {
    Reading reading{split_sheet(source, mark), {}, {}};
    if (mark == wide_blanks) {
        align_rows(reading.sheet);
        const auto header = find_sheet_header(reading.sheet);
        if (!header || !header->is_complete) { // blanks that only set columns off
            return reading;
        }
    }
    if (reading.sheet.rows.empty() || is_too_wide(reading.sheet, reading.problems)) {
        return reading;
    }
    auto tables = cut_tables(reading.sheet, reading.problems);
    bool have_columns = true;
    for (SheetTable& table : tables) {
        if (!table.columns) {
            table.columns = find_grading_columns(table.sheet, reading.problems);
        }
        have_columns = have_columns && table.columns;
    }
    if (have_columns && !reading.problems.has_errors()) {
        reading.tables = std::move(tables);
    }
    return reading;
}

/// Whether a tab cuts most lines: then nothing else does, for no text has tabs of its own.
bool is_cut_by_tabs(const Reading& reading) {
    const auto& rows = reading.sheet.rows;
    const auto cut = std::ranges::count_if(rows, [](const SheetRow& row) { return row.cells.size() > 1; });
    return reading.sheet.mark == '\t' && 2 * cut > static_cast<std::ptrdiff_t>(rows.size());
}

/// Of the marks that the text has the first between which columns are found; else the first that cuts its lines.
Reading choose_mark(const std::shared_ptr<const Source>& source) {
    std::optional<Reading> first;
    for (const char mark : possible_marks(source->text)) {
        Reading reading = try_mark(source, mark);
        if (!reading.tables.empty() || is_cut_by_tabs(reading)) {
            return reading;
        }
        if (!first && mark != wide_blanks) {
            first = std::move(reading);
        }
    }
    return std::move(*first);
}

std::optional<std::vector<SoilPoints>> read_sheet(const std::shared_ptr<const Source>& source, Problems& problems) {
    Reading reading = choose_mark(source);
    const bool has_values =
        std::ranges::any_of(reading.sheet.rows, [](const SheetRow& row) { return !row.is_comment; });
    if (!has_values) {
        problems.error("E505", {source, 0, 0, 1}, "the file is empty", expected_header);
        return std::nullopt;
    }
    problems.take_over(reading.problems);
    if (reading.tables.empty()) {
        return std::nullopt;
    }
    if (std::ranges::any_of(reading.tables, [](const SheetTable& table) {
            return table.columns->first_row >= table.sheet.rows.size();
        })) {
        problems.error(
            "E505", {source, 0, 0, 1}, "the file has headings and no values",
            "a line for each sieve: its size and the percent passing"
        );
        return std::nullopt;
    }
    return read_tables(reading.tables, problems);
}

std::optional<std::vector<SoilPoints>> read_ags_soils(const std::shared_ptr<const Source>& source, Problems& problems) {
    auto soils = read_ags(source, problems);
    return soils ? points_of(std::move(*soils), problems) : std::nullopt;
}

std::string names_of(const std::vector<NamedGrading>& soils) {
    constexpr std::size_t most = 12;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min(most, soils.size()); ++k) {
        names.push_back(soils[k].name);
    }
    return fmt::format(
        "{}{}", fmt::join(names, ", "), soils.size() > most ? fmt::format(" and {} more", soils.size() - most) : ""
    );
}

/// The specified sample, whatever its capitals.
NamedGrading choose(const std::vector<NamedGrading>& soils, const std::string& sample, const std::string& file) {
    std::vector<std::string> names;
    for (const NamedGrading& soil : soils) {
        names.push_back(soil.name);
        if (edit_distance(soil.name, sample) == 0) {
            return soil;
        }
    }
    throw CaseError(
        fmt::format("{}: no sample {}{}; it has {}", file, sample, near_hint(sample, names), names_of(soils)), file
    );
}

} // namespace

std::vector<NamedGrading>
parse_gradings(const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends) {
    const auto text = decode_sheet(source, problems);
    if (!text) {
        return {};
    }
    auto soils = looks_like_ags(text->text) ? read_ags_soils(text, problems) : read_sheet(text, problems);
    std::vector<NamedGrading> gradings;
    bool is_good = soils.has_value();
    const std::size_t count = soils ? soils->size() : 0;
    for (SoilPoints& soil : soils ? *soils : std::vector<SoilPoints>{}) {
        const std::string name = count > 1 ? soil.name : "";
        auto grading = make_grading(std::move(soil.points), source->name, {text, 0, 0, 1}, problems, ends);
        is_good = is_good && grading;
        if (grading) {
            check_derived(soil.derived, *grading, name, problems);
            gradings.push_back({name, std::move(*grading)});
        }
    }
    if (is_good && gradings.empty()) {
        problems.error(
            "E505", {text, 0, 0, 1}, "a grading curve needs at least two points, and there are 0",
            "a line for each sieve: its size and the percent passing"
        );
    }
    return is_good ? gradings : std::vector<NamedGrading>{};
}

std::optional<grains::Grading>
parse_grading(const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends) {
    auto soils = parse_gradings(source, problems, ends);
    if (soils.size() > 1) {
        problems.error(
            "E509", {source, 0, 0, 1},
            fmt::format(
                "the file holds the curves of {} samples, and one is needed: {}", soils.size(), names_of(soils)
            ),
            fmt::format("suffuse new --psd {} --sample NAME writes a case with one of them", source->name)
        );
        return std::nullopt;
    }
    return soils.empty() ? std::nullopt : std::optional(std::move(soils.front().grading));
}

GradingFile read_gradings(const std::shared_ptr<const Source>& source, CurveEnds ends, const std::string& sample) {
    Problems problems;
    GradingFile file{parse_gradings(source, problems, ends), problems.sorted()};
    if (problems.has_errors()) {
        throw CaseProblems(std::move(file.remarks));
    }
    if (!sample.empty() && !(file.soils.size() == 1 && file.soils.front().name.empty())) {
        file.soils = {choose(file.soils, sample, source->name)};
    }
    return file;
}

grains::Grading read_grading(const std::string& path, CurveEnds ends) {
    Problems problems;
    const auto grading = parse_grading(std::make_shared<Source>(Source{path, read_whole_file(path)}), problems, ends);
    if (!grading) {
        throw CaseProblems(problems.sorted());
    }
    return *grading;
}

} // namespace suffuse::gradings
