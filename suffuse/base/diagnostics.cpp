#include "suffuse/base/diagnostics.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/readable.hpp"
#include "suffuse/base/render_within.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>
#include <vector>

namespace suffuse {

namespace {

constexpr std::size_t most_shown = 160; ///< characters of a source line; a data file may be a line of megabytes

bool starts_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// Control characters could move the cursor of a terminal: a tab becomes a space, the others question marks.
std::string printable(std::string_view text) {
    std::string shown;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        shown += c == '\t' ? ' ' : (code < 0x20 || code == 0x7f) ? '?' : c;
    }
    return shown;
}

/// The stretch of a line that is shown, and the column of its first character.
struct Excerpt {
    std::string text;
    int first_column = 1;
    int characters = 0;
};

Excerpt cut_line(const std::string& line, int column, std::size_t shown_characters) {
    std::vector<std::size_t> starts;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (starts_character(line[k])) {
            starts.push_back(k);
        }
    }
    const auto at = static_cast<std::size_t>(std::max(column - 1, 0));
    const std::size_t first =
        starts.size() <= shown_characters || at < shown_characters / 2 ? 0 : at - shown_characters / 2;
    const std::size_t last = std::min(starts.size(), first + shown_characters);
    Excerpt excerpt;
    excerpt.first_column = static_cast<int>(first) + 1;
    if (first < last) {
        const std::size_t end = last < starts.size() ? starts[last] : line.size();
        excerpt.text = printable(std::string_view(line).substr(starts[first], end - starts[first]));
        excerpt.characters = static_cast<int>(last - first);
    }
    return excerpt;
}

struct Palette {
    std::string_view error, warning, frame, bold, off;
};

/// Columns left of the bar.
std::size_t gutter_of(const Diagnostic& d) {
    return d.line > 0 ? fmt::formatted_size("{}", d.line) : 1;
}

std::string render_one(const Diagnostic& d, const Palette& paint, std::size_t columns) {
    const std::string_view tone = d.is_warning ? paint.warning : paint.error;
    std::string out = fmt::format(
        "{}{}[{}]{}{}: {}{}\n", tone, d.is_warning ? "warning" : "error", d.code, paint.off, paint.bold,
        printable(d.message), paint.off
    );
    const std::string gutter(gutter_of(d), ' ');
    if (!d.file.empty()) {
        const std::string where = d.line > 0 ? fmt::format("{}:{}:{}", d.file, d.line, d.column) : d.file;
        out += fmt::format("{}{}-->{} {}\n", gutter, paint.frame, paint.off, printable(where));
    }
    constexpr std::size_t least_shown = 20, frame = 4; // the bar, and blanks next to it
    const std::size_t taken = gutter.size() + frame, room = columns > taken ? columns - taken : 0;
    const Excerpt excerpt = cut_line(d.source_line, d.column, std::clamp(room, least_shown, most_shown));
    if (d.line > 0 && !excerpt.text.empty()) {
        const int before = std::clamp(d.column - excerpt.first_column, 0, excerpt.characters);
        const int carets = std::max(1, std::min(d.length, excerpt.characters - before));
        const auto bar = [&](std::string_view head) { return fmt::format("{}{} |{}", paint.frame, head, paint.off); };
        out += fmt::format("{}\n{} {}\n", bar(gutter), bar(fmt::format("{}", d.line)), excerpt.text);
        out += fmt::format(
            "{} {}{}{}{}{}{}\n", bar(gutter), std::string(static_cast<std::size_t>(before), ' '), tone,
            std::string(static_cast<std::size_t>(carets), '^'), d.label.empty() ? "" : " ", printable(d.label),
            paint.off
        );
    }
    if (!d.help.empty()) {
        out += fmt::format("{} {}={} help: {}\n", gutter, paint.frame, paint.off, printable(d.help));
    }
    return out;
}

using Kin = std::vector<const Diagnostic*>;

/// Problems that share one entry: warnings of one code; errors of one file with the same advice, as in every line of
/// a table with the wrong mark between its columns. Others are alone.
std::vector<Kin> find_kin(const std::vector<Diagnostic>& list) {
    constexpr std::size_t most_errors = 3; // of one kind that are shown in full
    using Kind = std::tuple<bool, std::string_view, std::string_view, std::string_view>;
    std::map<Kind, std::size_t> counts, places;
    const auto kind_of = [](const Diagnostic& d) {
        return d.is_warning ? Kind{true, d.code, {}, {}} : Kind{false, d.code, d.help, d.file};
    };
    for (const Diagnostic& d : list) {
        ++counts[kind_of(d)];
    }
    std::vector<Kin> all;
    for (const Diagnostic& d : list) {
        const bool is_folded = d.is_warning || (!d.help.empty() && counts[kind_of(d)] > most_errors);
        const auto place = is_folded ? places.try_emplace(kind_of(d), all.size()).first->second : all.size();
        all.resize(std::max(all.size(), place + 1));
        all[place].push_back(&d);
    }
    return all;
}

/// One line for each further problem of a kind, the first few, under the help of the first.
std::string render_rest(const Kin& kin, std::size_t indent) {
    constexpr std::size_t most = 3;
    const Diagnostic& first = *kin.front();
    std::string out;
    for (std::size_t k = 1; k < std::min(kin.size(), most + 1); ++k) {
        const Diagnostic& other = *kin[k];
        const std::string where = other.line <= 0            ? ""
                                  : other.file == first.file ? fmt::format("line {}: ", other.line)
                                                             : fmt::format("{}:{}: ", other.file, other.line);
        out += fmt::format("{:{}} = also: {}\n", "", indent, printable(where + other.message));
    }
    if (kin.size() > most + 1) {
        out += fmt::format(
            "{:{}} = and {} more{}\n", "", indent, kin.size() - 1 - most,
            first.is_warning ? "; suffuse check --json lists all" : " with the same advice"
        );
    }
    return out;
}

/// From the mark on, where the line lies behind it. @return npos where the source ends before it.
std::size_t find_line(const std::string& text, int line, int passed, std::size_t begin) {
    for (; passed < line; ++passed) {
        const std::size_t end = text.find('\n', begin);
        if (end == std::string::npos) {
            return end;
        }
        begin = end + 1;
    }
    return begin;
}

/// The line that begins here.
std::string line_at(const std::string& text, std::size_t begin) {
    if (begin == std::string::npos) {
        return {};
    }
    std::string line = text.substr(begin, text.find('\n', begin) - begin);
    if (!line.empty() && line.back() == '\r') {
        line.pop_back();
    }
    return line;
}

} // namespace

std::string line_of(const Source& source, int line) {
    return line_at(source.text, find_line(source.text, line, 1, 0));
}

void Problems::add(Diagnostic diagnostic, const Place& place) {
    for (std::string* const text : {&diagnostic.message, &diagnostic.label, &diagnostic.help}) {
        *text = readable(*text);
    }
    if (place.source) {
        diagnostic.file = place.source->name;
        diagnostic.line = place.line;
        diagnostic.column = place.column;
        diagnostic.length = std::max(place.length, 1);
        if (place.line > 0) {
            if (last_line_.source != place.source || place.line < last_line_.line) {
                last_line_ = {place.source};
            }
            const std::string& text = place.source->text;
            const std::size_t begin = find_line(text, place.line, last_line_.line, last_line_.begin);
            diagnostic.source_line = as_utf8(line_at(text, begin));
            if (begin != std::string::npos) {
                last_line_ = {place.source, place.line, begin};
            }
        }
    }
    list_.push_back(std::move(diagnostic));
}

void Problems::error(std::string code, const Place& place, std::string message, std::string help, std::string label) {
    add({std::move(code), {}, 0, 0, 1, {}, std::move(message), std::move(label), std::move(help), false}, place);
}

void Problems::warning(std::string code, const Place& place, std::string message, std::string help, std::string label) {
    add({std::move(code), {}, 0, 0, 1, {}, std::move(message), std::move(label), std::move(help), true}, place);
}

void Problems::advise(const std::string& help) {
    const auto first = std::find_if(list_.begin(), list_.end(), [](const Diagnostic& d) { return !d.is_warning; });
    if (first != list_.end()) {
        first->help += (first->help.empty() ? "" : "; ") + help;
    }
}

void Problems::take_over(const Problems& other) {
    list_.insert(list_.end(), other.list_.begin(), other.list_.end());
}

bool Problems::has_errors() const {
    return std::any_of(list_.begin(), list_.end(), [](const Diagnostic& d) { return !d.is_warning; });
}

std::vector<Diagnostic> Problems::sorted() const {
    std::vector<std::string> files;
    const auto rank = [&](const std::string& file) {
        return std::find(files.begin(), files.end(), file) - files.begin();
    };
    for (const Diagnostic& d : list_) {
        if (rank(d.file) == static_cast<std::ptrdiff_t>(files.size())) {
            files.push_back(d.file);
        }
    }
    std::vector<Diagnostic> list = list_;
    std::stable_sort(list.begin(), list.end(), [&](const Diagnostic& a, const Diagnostic& b) {
        return std::tuple(rank(a.file), a.line, a.column) < std::tuple(rank(b.file), b.line, b.column);
    });
    std::vector<Diagnostic> once;
    for (const Diagnostic& d : list) {
        bool is_known = false; // those of one place stand together
        for (auto o = once.rbegin(); o != once.rend() && !is_known; ++o) {
            if (std::tie(o->file, o->line, o->column) != std::tie(d.file, d.line, d.column)) {
                break;
            }
            is_known = o->code == d.code && o->message == d.message;
        }
        if (!is_known) {
            once.push_back(d);
        }
    }
    return once;
}

std::string count_problems(const std::vector<Diagnostic>& list) {
    const auto warnings = std::count_if(list.begin(), list.end(), [](const Diagnostic& d) { return d.is_warning; });
    const auto errors = static_cast<std::ptrdiff_t>(list.size()) - warnings;
    const auto counted = [](std::ptrdiff_t n, std::string_view word) {
        return n == 0 ? std::string() : fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
    };
    const std::string first = counted(errors, "error"), second = counted(warnings, "warning");
    if (first.empty() && second.empty()) {
        return "no problems";
    }
    return first + (first.empty() || second.empty() ? "" : ", ") + second;
}

std::string render(const std::vector<Diagnostic>& list, bool color) {
    return render_within(list, color, std::string::npos);
}

std::string render_within(const std::vector<Diagnostic>& list, bool color, std::size_t columns) {
    const Palette paint = color ? Palette{"\x1b[1;31m", "\x1b[1;33m", "\x1b[34m", "\x1b[1m", "\x1b[0m"} : Palette{};
    std::string out;
    for (const Kin& kin : find_kin(list)) {
        out += render_one(*kin.front(), paint, columns) + render_rest(kin, gutter_of(*kin.front())) + "\n";
    }
    const bool has_errors = std::ranges::any_of(list, [](const Diagnostic& d) { return !d.is_warning; });
    return out + count_problems(list) + (has_errors ? "; nothing was run\n" : "\n");
}

CaseProblems::CaseProblems(std::vector<Diagnostic> list) : CaseError(render(list)), problems(std::move(list)) {
    for (const Diagnostic& d : problems) {
        if (d.is_warning) {
            continue;
        }
        file = d.file;
        line = d.line;
        break;
    }
}

} // namespace suffuse
