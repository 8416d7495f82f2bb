#pragma once
// Where words go: results to standard output, talk and errors to standard error, colors only where they are wanted.

#include "apps/command_line.hpp"
#include <functional>
#include <string>
#include <string_view>

namespace suffuse::apps {

class Console {
public:
    /// Before the command line is known: no colors, no JSON.
    Console() = default;
    explicit Console(const CommandLine& line);

    /// A line of the result; nothing where JSON is wanted instead.
    void result(std::string_view text) const;

    /// The one JSON document.
    void document(std::string_view json) const;

    /// A line of talk; nothing when quiet.
    void talk(std::string_view text) const;

    /// More talk, for --verbose.
    void detail(std::string_view text) const;

    /// For a part of the library that has something to warn of while it works: as talk.
    [[nodiscard]] std::function<void(const std::string&)> warner() const {
        return [*this](const std::string& text) { talk("warning: " + text); };
    }

    /// An error; always. "error:" stands before it unless it is `rendered` with its source line already.
    void error(std::string_view text, bool rendered = false) const;

    /// Brings what was written to its end. @throws IoError where standard output cannot take it; but a reader that has
    /// left, as `head` does when it has enough, has requested no more.
    void finish() const;

    [[nodiscard]] bool wants_json() const { return json_; }

    [[nodiscard]] bool is_quiet() const { return quiet_; }

    [[nodiscard]] bool is_verbose() const { return verbose_; }

    [[nodiscard]] bool has_color() const { return color_; } ///< on standard error

private:
    bool quiet_ = false, verbose_ = false, json_ = false, color_ = false;
};

/// Whether words can be written without waiting: not where nobody reads them any more, nor where a terminal or a pipe
/// is held up. A signal handler may ask.
bool takes_words(int descriptor);

/// Whether the reader of a pipe has left, or the terminal was closed.
bool has_lost_reader(int descriptor);

/// Whether lines can be redrawn on standard error.
bool can_redraw();

/// Whether the terminal understands UTF-8, by the usual variables of the environment.
bool supports_utf8();

/// Width of the terminal on standard error [columns].
std::size_t terminal_width();

/// Width that a line of a source may have there: of a file or a pipe any.
std::size_t source_width();

} // namespace suffuse::apps
