#pragma once
// Reading text tables that other programs wrote: lines with their numbers, fields, numbers that must be numbers. Every
// complaint names file, line, what was found and what was expected.

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace suffuse::io {

/// The whole of a file, plain or compressed with gzip. Throws IoError where it cannot be read.
/// @param look sees the beginning of the file before the rest is read, and may throw
std::string read_text(
    const std::filesystem::path& path, void (*look)(const std::filesystem::path&, std::string_view begin) = nullptr
);

/// The lines of a text, one after the other; blank ones and those that start with '#' are passed over.
class LineReader {
public:
    LineReader(std::string file, std::string_view text);

    /// Goes to the next line. @return whether there is one.
    bool next();

    /// The current line, without blanks at its ends and without its comment.
    [[nodiscard]] std::string_view line() const { return line_; }

    /// What follows '#' on the current line, likewise.
    [[nodiscard]] std::string_view comment() const { return comment_; }

    /// Of the current line, from 1.
    [[nodiscard]] int number() const { return number_; }

    /// Throws CaseError with the place of the current line in front.
    [[noreturn]] void complain(const std::string& message) const;

private:
    std::string file_;
    std::string_view rest_, line_, comment_;
    int number_ = 0;
};

/// Without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// Fields of a line, between marks (blanks around them do not count) or between blanks.
std::vector<std::string_view> split_at(std::string_view line, char mark);
std::vector<std::string_view> split_at_blanks(std::string_view line);

/// A number that is all of `text`, perhaps behind a +; it may be infinite or none ("nan").
template <class T>
std::optional<T> number_of(std::string_view text) {
    const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
    T value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool is_whole = error == std::errc{} && end == digits.data() + digits.size();
    return is_whole ? std::optional(value) : std::nullopt;
}

/// A finite number; complains in the name of `column` where it is none.
double to_number(const LineReader& reader, std::string_view field, std::string_view column);

/// A whole number of zero or more, likewise.
std::size_t to_count(const LineReader& reader, std::string_view field, std::string_view column);

} // namespace suffuse::io
