#include "suffuse/gradings/read_grading.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/gradings/ags_grading.hpp"
#include "suffuse/gradings/grading_tables.hpp"
#include "suffuse/gradings/guess_readings.hpp"
#include "suffuse/gradings/named_columns.hpp"
#include "suffuse/gradings/sheet_header.hpp"
#include "suffuse/gradings/sheet_text.hpp"
#include "suffuse/gradings/sieve_standard.hpp"
#include "suffuse/gradings/thousands.hpp"

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

/// The specified table alone; all where there is no such table, which is reported.
std::vector<SheetTable>
restrict_to(const ReadingOptions& options, const Sheet& sheet, std::vector<SheetTable> tables, Problems& problems) {
    const auto number = static_cast<std::size_t>(options.sheet.value_or(1));
    if (number < 1 || number > tables.size()) {
        problems.error(
            "E506", sheet.rows.front().place,
            fmt::format("sheet {}: the file has {} {}", number, tables.size(), tables.size() == 1 ? "table" : "tables"),
            "count the tables from 1"
        );
    } else if (options.sheet) {
        tables = {tables[number - 1]};
    }
    return tables;
}

/// The sheet of columns that the user names: of the file, or of one of its tables.
void take_named_columns(const ReadingOptions& options, Reading& reading) {
    Problems unheard;
    const auto tables = options.sheet
                            ? restrict_to(options, reading.sheet, cut_tables(reading.sheet, unheard), reading.problems)
                            : std::vector<SheetTable>{{reading.sheet}};
    if (!reading.problems.has_errors()) {
        if (auto table = read_named_columns(tables.front().sheet, options, reading.problems)) {
            reading.tables.push_back(std::move(*table));
        }
    }
}

/// The tables of a sheet with their columns, where all have some.
void take_tables(const ReadingOptions& options, Reading& reading) {
    auto tables = restrict_to(options, reading.sheet, cut_tables(reading.sheet, reading.problems), reading.problems);
    bool have_columns = true;
    for (SheetTable& table : tables) {
        table.columns = table.columns ? table.columns : find_grading_columns(table.sheet, reading.problems);
        have_columns = have_columns && table.columns;
        if (table.columns) {
            table.columns->stated_unit = table.size_unit;
        }
    }
    if (have_columns && !reading.problems.has_errors()) {
        reading.tables = std::move(tables);
    }
}

Reading try_mark(const std::shared_ptr<const Source>& source, char mark, const ReadingOptions& options) {
    Reading reading{split_sheet(source, mark), {}, {}};
    take_numbered_sieves(reading.sheet);
    join_sure_groups(reading.sheet);
    if (mark == wide_blanks) {
        align_rows(reading.sheet);
        const auto header = find_sheet_header(reading.sheet);
        if (!header || !header->is_complete) { // blanks that only set columns off
            return reading;
        }
    }
    if (const auto lines = split_lines(options.rows); lines && !options.name_columns()) {
        std::erase_if(reading.sheet.rows, [&lines](const SheetRow& row) {
            return row.place.line < lines->first || row.place.line > lines->second;
        });
    }
    if (reading.sheet.rows.empty() || is_too_wide(reading.sheet, reading.problems)) {
        return reading;
    }
    options.name_columns() ? take_named_columns(options, reading) : take_tables(options, reading);
    for (SheetTable& table : reading.tables) {
        table.columns->is_by_number = options.by == "number";
    }
    return reading;
}

/// Whether a tab cuts most lines: then nothing else does, for no text has tabs of its own.
bool is_cut_by_tabs(const Reading& reading) {
    const auto& rows = reading.sheet.rows;
    const auto cut = std::ranges::count_if(rows, [](const SheetRow& row) { return row.cells.size() > 1; });
    return reading.sheet.mark == '\t' && 2 * cut > static_cast<std::ptrdiff_t>(rows.size());
}

bool holds_two_numbers(const SheetCell& cell) {
    const std::string& text = cell.text;
    const std::size_t blank = text.find(' ');
    return blank != std::string::npos && plain_number(text.substr(0, blank), true) &&
           plain_number(text.substr(blank + 1), true);
}

/// Whether the mark cuts each line below headings that it cuts, too: then the text has no other columns, and what is
/// wrong is wrong between these.
bool is_cut_throughout(const Reading& reading) {
    const auto rows = value_rows(reading.sheet, 0);
    return !rows.empty() && !has_number(*rows.front()) && reading.sheet.mark != wide_blanks &&
           std::ranges::all_of(rows, [](const SheetRow* row) {
               return row->cells.size() > 1 && std::ranges::none_of(row->cells, holds_two_numbers);
           });
}

/// Of the marks that the text has the first between which columns are found; else the first that cuts its lines.
Reading choose_mark(const std::shared_ptr<const Source>& source, const ReadingOptions& options) {
    std::optional<Reading> first;
    for (const char mark : possible_marks(source->text)) {
        Reading reading = try_mark(source, mark, options);
        if (!reading.tables.empty() || is_cut_by_tabs(reading) || is_cut_throughout(reading)) {
            return reading;
        }
        if (!first && mark != wide_blanks) {
            first = std::move(reading);
        }
    }
    return std::move(*first);
}

/// Shares of the number of grains make another curve than those of their mass. @return whether none is read as such
bool check_counts(const std::vector<SheetTable>& tables, const ReadingOptions& options, Problems& problems) {
    for (const SheetTable& table : tables) {
        const auto& shares = table.columns->shares;
        const auto counted = std::ranges::find_if(shares, [](const ShareColumn& share) {
            return share.counts_grains && share.unit != ShareUnit::Mass && share.unit != ShareUnit::Count;
        });
        if (options.by.empty() && counted != shares.end()) {
            const SheetRow& heads = table.sheet.rows[table.columns->first_row - 1];
            problems.error(
                "E506", place_at(heads, counted->index),
                fmt::format("`{}`: shares of the number of grains, not of their mass", text_at(heads, counted->index)),
                "add --by number, which converts them; or --by mass if they are shares of mass"
            );
            return false;
        }
    }
    return true;
}

std::optional<std::vector<SoilPoints>>
read_sheet(const std::shared_ptr<const Source>& source, const ReadingOptions& options, Problems& problems) {
    if (!options.rows.empty() && !split_lines(options.rows)) {
        problems.error(
            "E506", {source, 0, 0, 1}, fmt::format("rows: `{}` are no lines", options.rows),
            "the first and the last line: --rows 5-12"
        );
        return std::nullopt;
    }
    if (!options.by.empty() && options.by != "mass" && options.by != "number") {
        problems.error("E506", {source, 0, 0, 1}, fmt::format("by: `{}`", options.by), "by mass or by number");
        return std::nullopt;
    }
    Reading reading = choose_mark(source, options);
    if (value_rows(reading.sheet, 0).empty()) {
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
    if (!check_counts(reading.tables, options, problems)) {
        return std::nullopt;
    }
    Problems undecided;
    check_sieve_standard(reading.sheet, reading.tables, undecided);
    settle_thousands(reading.sheet, reading.tables, undecided);
    problems.take_over(undecided);
    return undecided.has_errors() ? std::nullopt : read_tables(reading.tables, problems);
}

std::string names_of(const std::vector<NamedGrading>& soils) {
    constexpr std::size_t most = 12;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < std::min(most, soils.size()); ++k) {
        names.push_back(soils[k].name.empty() ? soils[k].sample : soils[k].name);
    }
    return fmt::format(
        "{}{}", fmt::join(names, ", "), soils.size() > most ? fmt::format(" and {} more", soils.size() - most) : ""
    );
}

/// The specified sample; where none is called exactly so, whatever its capitals.
NamedGrading choose(const std::vector<NamedGrading>& soils, const std::string& sample, const std::string& file) {
    std::vector<std::string> names;
    for (const NamedGrading& soil : soils) {
        names.push_back(soil.name.empty() ? soil.sample : soil.name);
    }
    auto found = std::ranges::find(names, sample);
    if (found == names.end()) {
        found = std::ranges::find_if(names, [&](const std::string& name) { return edit_distance(name, sample) == 0; });
    }
    if (found != names.end()) {
        return soils[static_cast<std::size_t>(found - names.begin())];
    }
    if (names.size() == 1 && names.front().empty()) {
        throw CaseError(
            fmt::format(
                "{}: no sample {}: the file has one curve and names no sample; read it without a name", file, sample
            ),
            file
        );
    }
    throw CaseError(
        fmt::format("{}: no sample {}{}; it has {}", file, sample, near_hint(sample, names), names_of(soils)), file
    );
}

/// All curves of a decoded text.
std::vector<NamedGrading> parse_text(
    const std::shared_ptr<const Source>& text, const std::string& origin, CurveEnds ends, const ReadingOptions& options,
    Problems& problems
) {
    const bool is_ags = options.is_empty() && looks_like_ags(text->text);
    auto sieved = is_ags ? read_ags(text, problems) : std::nullopt;
    auto soils = sieved   ? points_of(std::move(*sieved), {}, problems)
                 : is_ags ? std::nullopt
                          : read_sheet(text, options, problems);
    std::vector<NamedGrading> gradings;
    bool is_good = soils.has_value();
    for (SoilPoints& soil : soils ? *soils : std::vector<SoilPoints>{}) {
        const std::string name = soils->size() > 1 ? soil.name : "";
        auto grading = make_grading(std::move(soil.points), origin, {text, 0, 0, 1}, problems, ends);
        is_good = is_good && grading;
        if (grading) {
            check_derived(soil.derived, *grading, name, problems);
            const std::string in_heading = read_heading(soil.reading.share).rest; // "TP9 passing [%]"
            const std::string& sample = soil.sample.empty() ? in_heading : soil.sample;
            gradings.push_back({name, sample, std::move(*grading), soil.reading});
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

/// Whether it is open which columns are read as what; a cell that is wrong is mended in the sheet.
bool may_be_named(const Problems& problems) {
    return std::ranges::none_of(problems.sorted(), [](const Diagnostic& one) {
        return !one.is_warning && (one.code == "E502" || one.code == "E503");
    });
}

/// The options that read a text that could not be read without: those of the likeliest columns, and what else fits
/// them.
std::string find_command(const std::shared_ptr<const Source>& text, CurveEnds ends) {
    constexpr std::size_t most_bytes = 1U << 16U; // it is read again for each guess
    std::vector<std::string> commands;
    std::string size, share;
    bool has_open_unit = false;
    const auto marks = text->text.size() > most_bytes ? std::vector<char>{} : possible_marks(text->text);
    for (auto mark = marks.begin(); mark != marks.end() && commands.empty(); ++mark) {
        for (const auto& [guess, is_unit_open] : guess_readings(split_sheet(text, *mark))) {
            const std::string own = guess.share + guess.passing + guess.retained + guess.mass;
            Problems unheard;
            const bool is_other = !commands.empty() && (guess.size != size || own != share);
            const bool is_read = !is_other && !parse_text(text, text->name, ends, guess, unheard).empty();
            const auto remarks = unheard.sorted();
            const bool is_half = std::ranges::find(remarks, columns_end, &Diagnostic::code) != remarks.end();
            if (is_read && !is_half) { // of a second table it would read nothing
                ReadingOptions shown = guess;
                shown.size = is_unit_open ? guess.size.substr(0, guess.size.find(':')) + ":UNIT" : guess.size;
                commands.push_back(command_words(shown));
                size = guess.size, share = own, has_open_unit = has_open_unit || is_unit_open;
            }
        }
    }
    return commands.empty() ? ""
                            : fmt::format(
                                  "suffuse assess {} {}{}", shell_word(text->name), fmt::join(commands, " or "),
                                  has_open_unit ? " with the unit of the sizes, mm or um" : ""
                              );
}

} // namespace

std::vector<NamedGrading> parse_gradings(
    const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends, const ReadingOptions& options
) {
    Problems own;
    std::vector<NamedGrading> gradings;
    if (const auto text = decode_sheet(source, own)) {
        gradings = parse_text(text, source->name, ends, options, own);
        if (gradings.empty() && options.is_empty() && !looks_like_ags(text->text) && may_be_named(own)) {
            if (const std::string command = find_command(text, ends); !command.empty()) {
                own.advise("or say how to read it: " + command);
            }
        }
    }
    problems.take_over(own);
    return gradings;
}

std::optional<grains::Grading> parse_grading(
    const std::shared_ptr<const Source>& source, Problems& problems, CurveEnds ends, const ReadingOptions& options
) {
    auto soils = parse_gradings(source, problems, ends, options);
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

GradingFile read_gradings(
    const std::shared_ptr<const Source>& source, CurveEnds ends, const std::string& sample,
    const ReadingOptions& options
) {
    Problems problems;
    auto soils = parse_gradings(source, problems, ends, options);
    GradingFile file{std::move(soils), problems.sorted()};
    if (problems.has_errors()) {
        throw CaseProblems(std::move(file.remarks));
    }
    if (!sample.empty()) {
        file.soils = {choose(file.soils, sample, source->name)};
    }
    return file;
}

grains::Grading read_grading(const std::string& path, CurveEnds ends, const ReadingOptions& options) {
    Problems problems;
    const auto source = std::make_shared<Source>(Source{path, read_whole_file(path)});
    const auto grading = parse_grading(source, problems, ends, options);
    if (!grading) {
        throw CaseProblems(problems.sorted());
    }
    return *grading;
}

} // namespace suffuse::gradings
