#include "suffuse/base/diagnostics.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/base/render_within.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

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
    constexpr std::size_t least_shown = 20, frame = 4; // the bar, and blanks beside it
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

/// Warnings of one code; errors of one file that ask for the same, as in every line of a table with the wrong mark
/// between its columns.
bool are_alike(const Diagnostic& a, const Diagnostic& b) {
    if (a.is_warning != b.is_warning || a.code != b.code) {
        return false;
    }
    return a.is_warning || (!a.help.empty() && a.help == b.help && a.file == b.file);
}

/// One line for each further problem of the kind of `first`, the first few, under its help.
template <class Iterator, class IsAlike>
std::string render_rest(Iterator first, Iterator end, IsAlike is_alike, std::size_t indent) {
    constexpr std::ptrdiff_t most = 3;
    const std::ptrdiff_t count = std::count_if(first + 1, end, is_alike);
    std::string out;
    std::ptrdiff_t told = 0;
    for (Iterator other = first + 1; other != end && told < most; ++other) {
        if (is_alike(*other)) {
            const std::string where = other->line <= 0             ? ""
                                      : other->file == first->file ? fmt::format("line {}: ", other->line)
                                                                   : fmt::format("{}:{}: ", other->file, other->line);
            out += fmt::format("{:{}} = also: {}\n", "", indent, printable(where + other->message));
            ++told;
        }
    }
    const std::string more = fmt::format(
        "{:{}} = and {} more{}\n", "", indent, count - told,
        first->is_warning ? "; suffuse check --json lists all" : " that ask for the same"
    );
    return out + (count > told ? more : "");
}

} // namespace

std::string line_of(const Source& source, int line) {
    std::size_t begin = 0;
    for (int passed = 1; passed < line; ++passed) {
        const std::size_t end = source.text.find('\n', begin);
        if (end == std::string::npos) {
            return {};
        }
        begin = end + 1;
    }
    std::string text = source.text.substr(begin, source.text.find('\n', begin) - begin);
    if (!text.empty() && text.back() == '\r') {
        text.pop_back();
    }
    return text;
}

void Problems::add(Diagnostic diagnostic, const Place& place) {
    if (place.source) {
        diagnostic.file = place.source->name;
        diagnostic.line = place.line;
        diagnostic.column = place.column;
        diagnostic.length = std::max(place.length, 1);
        if (place.line > 0) {
            diagnostic.source_line = as_utf8(line_of(*place.source, place.line));
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
    constexpr std::ptrdiff_t most_errors = 3; // of one kind that are shown in full
    bool has_errors = false;
    for (auto d = list.begin(); d != list.end(); ++d) {
        has_errors = has_errors || !d->is_warning;
        const std::ptrdiff_t kin =
            std::count_if(list.begin(), list.end(), [&](const Diagnostic& other) { return are_alike(*d, other); });
        const bool is_folded = d->is_warning || kin > most_errors;
        const auto is_alike = [&](const Diagnostic& other) { return is_folded && are_alike(*d, other); };
        if (std::none_of(list.begin(), d, is_alike)) {
            out += render_one(*d, paint, columns) + render_rest(d, list.end(), is_alike, gutter_of(*d)) + "\n";
        }
    }
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
