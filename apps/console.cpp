#include "apps/console.hpp"

#include "suffuse/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sys/ioctl.h>
#include <unistd.h>

namespace suffuse::apps {
namespace {

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool wants_color(Color color) {
    if (color != Color::Auto) {
        return color == Color::Always;
    }
    return environment("NO_COLOR").empty() && can_redraw();
}

void write_line(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);
    if (text.empty() || text.back() != '\n') {
        std::fputc('\n', stream);
    }
}

} // namespace

Console::Console(const CommandLine& line)
    : quiet_(line.quiet), verbose_(line.verbose), json_(line.json), color_(wants_color(line.color)) {}

void Console::result(std::string_view text) const {
    if (!json_) {
        write_line(stdout, text);
    }
}

void Console::document(std::string_view json) const {
    if (json_) {
        write_line(stdout, json);
    }
}

void Console::talk(std::string_view text) const {
    if (!quiet_) {
        std::fflush(stdout); // in a file that takes both, lines stand in the order in which they were said
        write_line(stderr, text);
    }
}

void Console::detail(std::string_view text) const {
    if (verbose_ && !quiet_) {
        std::fflush(stdout);
        write_line(stderr, text);
    }
}

void Console::error(std::string_view text, bool rendered) const {
    if (!rendered) {
        std::fputs(color_ ? "\x1b[1;31merror\x1b[0m: " : "error: ", stderr);
    }
    write_line(stderr, text);
}

void Console::finish() const {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw IoError(std::string("standard output cannot be written: ") + std::strerror(errno != 0 ? errno : EIO));
    }
}

bool can_redraw() {
    const std::string terminal = environment("TERM");
    return isatty(STDERR_FILENO) == 1 && !terminal.empty() && terminal != "dumb";
}

bool speaks_utf8() {
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        const std::string value = environment(name);
        if (value.empty()) {
            continue;
        }
        return value.find("UTF-8") != std::string::npos || value.find("utf8") != std::string::npos;
    }
    return false;
}

std::size_t terminal_width() {
    constexpr std::size_t usual = 80;
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) {
        return usual;
    }
    return size.ws_col;
}

} // namespace suffuse::apps
