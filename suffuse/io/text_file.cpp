#include "suffuse/io/text_file.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/interruption.hpp"
#include "suffuse/base/read_text.hpp"
#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <type_traits>
#include <utility>
#include <zlib.h>

namespace suffuse::io {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& reason) {
    throw IoError(fmt::format("cannot read {}: {}; check the name and that the file is complete", path.string(), reason)
    );
}

/// No text of numbers shrinks to a hundredth, and none is so long. Files that are made to fill memory end here.
void check_length(const std::filesystem::path& path, std::size_t length, z_off_t packed) {
    constexpr std::size_t least = std::size_t{64} << 20U, most = std::size_t{16} << 30U; // [bytes]
    constexpr std::size_t largest_ratio = 100;
    if (length > least && packed > 0 && length / largest_ratio > static_cast<std::size_t>(packed)) {
        fail_to_read(
            path, fmt::format("it unpacks to more than {} times its size, which no packing does", largest_ratio)
        );
    }
    if (length > most) {
        fail_to_read(path, fmt::format("it is longer than {} GiB", most >> 30U));
    }
}

/// What a complaint shows of a field: long ones are cut, and a file may hold anything.
std::string shown(std::string_view field) {
    constexpr std::size_t most = 40;
    std::string text(field.substr(0, most));
    for (char& c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x20 || code == 0x7f) {
            c = '?';
        }
    }
    return "\"" + text + (field.size() > most ? "...\"" : "\"");
}

} // namespace

std::string
read_text(const std::filesystem::path& path, void (*look)(const std::filesystem::path&, std::string_view begin)) {
    const int descriptor = open_for_reading(path.string());
    if (descriptor < 0) {
        fail_to_read(path, std::generic_category().message(errno));
    }

    struct stat about {};

    const bool is_device = fstat(descriptor, &about) == 0 && S_ISCHR(about.st_mode);
    const std::unique_ptr<std::remove_pointer_t<gzFile>, int (*)(gzFile)> file(gzdopen(descriptor, "rb"), gzclose);
    if (!file || is_device) {
        fail_to_read(path, is_device ? "it is a device, not a file" : "out of memory");
    }
    std::string text;
    std::string block(std::size_t{1} << 18, '\0');
    for (;;) {
        Interruption::look_up();
        const int count = gzread(file.get(), block.data(), static_cast<unsigned>(block.size()));
        int error = Z_OK;
        const char* reason = gzerror(file.get(), &error);
        if (count < 0 || (error != Z_OK && error != Z_STREAM_END)) {
            fail_to_read(path, error == Z_ERRNO ? std::generic_category().message(errno) : reason);
        }
        if (count == 0) {
            return text;
        }
        if (text.empty() && look != nullptr) {
            look(path, std::string_view(block).substr(0, static_cast<std::size_t>(count)));
        }
        text.append(block, 0, static_cast<std::size_t>(count));
        check_length(path, text.size(), gzoffset(file.get()));
    }
}

LineReader::LineReader(std::string file, std::string_view text) : file_(std::move(file)), rest_(text) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (rest_.starts_with(byte_order_mark)) {
        rest_.remove_prefix(byte_order_mark.size());
    }
}

bool LineReader::next() {
    constexpr int lines_between_looks = 1024;
    while (!rest_.empty()) {
        if (number_ % lines_between_looks == 0) {
            Interruption::look_up();
        }
        const std::size_t end = rest_.find('\n');
        line_ = trimmed(rest_.substr(0, end));
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++number_;
        const std::size_t mark = line_.find('#');
        comment_ = mark == std::string_view::npos ? std::string_view{} : trimmed(line_.substr(mark + 1));
        line_ = trimmed(line_.substr(0, mark));
        if (!line_.empty()) {
            return true;
        }
    }
    line_ = {};
    return false;
}

void LineReader::complain(const std::string& message) const {
    throw CaseError(fmt::format("{}:{}: {}", file_, number_, message), file_, number_);
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::vector<std::string_view> split_at(std::string_view line, char mark) {
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t end = line.find(mark);
        fields.push_back(trimmed(line.substr(0, end)));
        if (end == std::string_view::npos) {
            return fields;
        }
        line.remove_prefix(end + 1);
    }
}

std::vector<std::string_view> split_at_blanks(std::string_view line) {
    std::vector<std::string_view> fields;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = line.find_first_of(blanks);
        fields.push_back(line.substr(0, end));
        line.remove_prefix(end == std::string_view::npos ? line.size() : end);
    }
    return fields;
}

double to_number(const LineReader& reader, std::string_view field, std::string_view column) {
    const std::optional<double> value = number_of<double>(field);
    if (!value || !std::isfinite(*value)) {
        const bool has_comma = field.find(',') != std::string_view::npos;
        reader.complain(fmt::format(
            "column {}: found {}, expected a finite number{}", column, shown(field),
            has_comma ? " with a decimal point" : ""
        ));
    }
    return *value;
}

std::size_t to_count(const LineReader& reader, std::string_view field, std::string_view column) {
    const std::optional<std::size_t> value = number_of<std::size_t>(field);
    if (!value) {
        reader.complain(fmt::format("{}: found {}, expected a whole number", column, shown(field)));
    }
    return *value;
}

} // namespace suffuse::io
