#include "suffuse/base/read_text.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <system_error>

namespace suffuse {

namespace {

constexpr std::size_t largest_file = std::size_t{64} << 20U; ///< [bytes]
constexpr int deepest_key = 32;   ///< parts of one dotted key; the parser recurses once for each
constexpr int most_reported = 20; ///< of one kind: a file in another encoding has thousands

/// A place that walks through a text.
struct Walker {
    std::shared_ptr<const Source> source;
    std::size_t at = 0;
    int line = 1, column = 1;

    [[nodiscard]] bool at_end() const { return at >= source->text.size(); }

    [[nodiscard]] char here() const { return source->text[at]; }

    [[nodiscard]] bool sees(std::string_view token) const { return source->text.compare(at, token.size(), token) == 0; }

    void step() {
        const bool is_line_end = here() == '\n';
        at += std::max<std::size_t>(1, character_size(source->text, at));
        line += is_line_end ? 1 : 0;
        column = is_line_end ? 1 : column + 1;
    }

    void step(int characters) {
        for (int k = 0; k < characters && !at_end(); ++k) {
            step();
        }
    }

    [[nodiscard]] Place place() const { return {source, line, column, 1}; }
};

/// Walks over a string from its opening quotes to behind its closing ones, or to where the parser will complain.
void skip_string(Walker& w) {
    const char quote = w.here();
    const std::string mark(3, quote);
    const bool is_long = w.sees(mark);
    w.step(is_long ? 3 : 1);
    while (!w.at_end()) {
        if (quote == '"' && w.here() == '\\') {
            w.step(2);
        } else if (is_long && w.sees(mark)) {
            w.step(3);
            return;
        } else if (!is_long && w.here() == quote) {
            w.step();
            return;
        } else if (!is_long && w.here() == '\n') {
            return;
        } else {
            w.step();
        }
    }
}

void skip_comment(Walker& w) {
    while (!w.at_end() && w.here() != '\n') {
        w.step();
    }
}

/// Reports a run of characters that TOML only allows in quotes.
void report_run(Walker& w, Problems& problems, bool is_reported) {
    Place place = w.place();
    const std::size_t begin = w.at;
    place.length = 0;
    while (!w.at_end() && static_cast<unsigned char>(w.here()) >= 0x80) {
        w.step();
        ++place.length;
    }
    if (!is_reported) {
        return;
    }
    const std::string run = w.source->text.substr(begin, w.at - begin);
    const bool is_quote = run.starts_with("\u201c") || run.starts_with("\u201d") || run.starts_with("\u2018") ||
                          run.starts_with("\u2019");
    problems.error(
        "E101", place, fmt::format("\"{}\" outside of quotes", run),
        is_quote ? "write the straight quote \", not a typographic one"
                 : "keys and values outside of quotes are plain ASCII; put this between straight quotes"
    );
}

[[noreturn]] void fail_to_read(const std::string& path, const std::string& why) {
    throw IoError(fmt::format("cannot read {}: {}", path.empty() ? "a file without a name" : path, why));
}

} // namespace

std::size_t character_size(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[at + k]); };
    const unsigned first = byte(0);
    const std::size_t size = first < 0x80                    ? 1
                             : first >= 0xC2 && first < 0xE0 ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
    if (size == 0 || at + size > text.size()) {
        return 0;
    }
    for (std::size_t k = 1; k < size; ++k) {
        if ((byte(k) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    const bool is_overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool is_surrogate = first == 0xED && byte(1) >= 0xA0;
    const bool is_beyond = first == 0xF4 && byte(1) >= 0x90;
    return is_overlong || is_surrogate || is_beyond ? 0 : size;
}

std::string as_utf8(std::string_view text) {
    std::string valid;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t size = character_size(text, at);
        valid += size == 0 ? "?" : text.substr(at, size);
        at += std::max<std::size_t>(1, size);
    }
    return valid;
}

int open_for_reading(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file >= 0) {
        fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK); // once it is open, writers are waited for
    }
    return file;
}

std::string read_whole_file(const std::string& path) {
    const int descriptor = open_for_reading(path);
    if (descriptor < 0) {
        fail_to_read(
            path, errno == ENOENT ? "there is no such file; check its name, and the folder that it is looked for from"
                                  : std::strerror(errno)
        );
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(fdopen(descriptor, "rb"), &std::fclose);
    if (!file) {
        fail_to_read(path, "out of memory");
    }
    return read_whole_stream(file.get(), path);
}

std::string read_whole_stream(std::FILE* stream, const std::string& path) {
    std::string text;
    char block[65536];
    while (const std::size_t count = std::fread(block, 1, sizeof block, stream)) {
        text.append(block, count);
        if (text.size() > largest_file) {
            fail_to_read(path, "it is larger than 64 MiB, which no case or grading is");
        }
    }
    if (std::ferror(stream) != 0) {
        const int reason = errno;
        const std::string within = path + (path.ends_with('/') ? "" : "/") + "case.toml";
        if (std::error_code none; reason == EISDIR && std::filesystem::exists(within, none)) {
            fail_to_read(path, "it is a folder; its case is " + within);
        }
        fail_to_read(path, reason == EISDIR ? "it is a folder; give a file in it" : std::strerror(reason));
    }
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

bool check_encoding(const std::shared_ptr<const Source>& source, Problems& problems) {
    if (source->text.starts_with("\xFF\xFE") || source->text.starts_with("\xFE\xFF")) {
        problems.error("E100", {source, 0, 0, 1}, "the file is UTF-16 text", "save it as UTF-8");
        return false;
    }
    Walker w{source};
    while (!w.at_end()) {
        const bool is_zero = w.here() == '\0';
        if (is_zero || character_size(source->text, w.at) == 0) {
            problems.error(
                "E100", {source, w.line, w.column, 1},
                is_zero ? "this is not a text file: it holds zero bytes" : "this is not UTF-8 text",
                is_zero ? "is this the right file?" : "save the file as UTF-8"
            );
            return false;
        }
        w.step();
    }
    return true;
}

bool check_toml_characters(const std::shared_ptr<const Source>& source, Problems& problems) {
    Walker w{source};
    int found = 0, dots = 0;
    while (!w.at_end()) {
        const char c = w.here();
        if (c == '"' || c == '\'') {
            skip_string(w);
        } else if (c == '#') {
            skip_comment(w);
        } else if (static_cast<unsigned char>(c) >= 0x80) {
            report_run(w, problems, found++ < most_reported);
        } else {
            constexpr std::string_view key_ends = "=,[]{}\n";
            dots = c == '.' ? dots + 1 : key_ends.find(c) != std::string_view::npos ? 0 : dots;
            if (dots == deepest_key) {
                problems.error(
                    "E101", w.place(), fmt::format("a key of more than {} parts", deepest_key),
                    "no key of a case is nested that deep"
                );
                return false;
            }
            w.step();
        }
    }
    return found == 0;
}

} // namespace suffuse
