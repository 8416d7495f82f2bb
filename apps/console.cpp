#include "apps/console.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/readable.hpp"

#include "apps/printable.hpp"
#include "apps/wording.hpp"
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <poll.h>
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

/// Columns of the terminal behind the stream; 0 where there is none.
std::size_t width_of(int stream) {
    winsize size{};
    return isatty(stream) == 1 && ioctl(stream, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

/// What poll says of a descriptor that would be written to.
short state_of(int descriptor) {
    pollfd request{descriptor, POLLOUT, 0};
    return poll(&request, 1, 0) > 0 ? request.revents : short{0};
}

/// As it is, in lines that end.
void write_whole(std::FILE* stream, std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stream);
    if (text.empty() || text.back() != '\n') {
        std::fputc('\n', stream);
    }
    std::fflush(stream); // in order with what the other stream says
}

/// Folded to the terminal, where there is one. What programs read from a pipe keeps the bytes of names.
void write_line(std::FILE* stream, std::string_view text, bool colored) {
    constexpr std::size_t least = 40; // below it, folding makes things worse
    const std::size_t width = width_of(fileno(stream));
    const bool is_for_people = stream == stderr || isatty(fileno(stream)) == 1;
    const std::string shown = is_for_people ? printable(text, colored) : std::string(text);
    write_whole(stream, width >= least ? folded(shown, width) : shown);
}

} // namespace

Console::Console(const CommandLine& line)
    : quiet_(line.quiet), verbose_(line.verbose), json_(line.json), color_(wants_color(line.color)) {}

void Console::result(std::string_view text) const {
    if (!json_) {
        write_line(stdout, text, color_);
    }
}

void Console::document(std::string_view json) const {
    if (json_) {
        write_whole(stdout, json);
    }
}

void Console::talk(std::string_view text) const {
    if (!quiet_) {
        std::fflush(stdout); // in a file that takes both, lines stand in the order in which they were said
        write_line(stderr, text, color_);
    }
}

void Console::detail(std::string_view text) const {
    if (verbose_ && !quiet_) {
        std::fflush(stdout);
        write_line(stderr, text, color_);
    }
}

void Console::error(std::string_view text, bool rendered) const {
    const std::string_view word = rendered ? "" : color_ ? "\x1b[1;31merror\x1b[0m: " : "error: ";
    write_line(stderr, std::string(word).append(readable(text)), color_);
}

void Console::finish() const {
    errno = 0;
    const bool has_failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
    if (has_failed && !has_lost_reader(STDOUT_FILENO)) {
        throw IoError(std::string("standard output cannot be written: ") + std::strerror(errno != 0 ? errno : EIO));
    }
}

bool takes_words(int descriptor) {
    return (state_of(descriptor) & (POLLOUT | POLLERR | POLLHUP | POLLNVAL)) == POLLOUT;
}

bool has_lost_reader(int descriptor) {
    return (state_of(descriptor) & (POLLERR | POLLHUP)) != 0;
}

bool can_redraw() {
    const std::string terminal = environment("TERM");
    return isatty(STDERR_FILENO) == 1 && !terminal.empty() && terminal != "dumb";
}

bool supports_utf8() {
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
    const std::size_t width = width_of(STDERR_FILENO);
    return width > 0 ? width : usual;
}

std::size_t source_width() {
    const std::size_t width = width_of(STDERR_FILENO);
    return width > 0 ? width : std::string::npos;
}

} // namespace suffuse::apps
