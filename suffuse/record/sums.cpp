#include "suffuse/record/sums.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/sha256.hpp"
#include "suffuse/io/own_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <vector>

namespace suffuse::record {
namespace {

constexpr std::size_t sum_digits = 64, sum_gap = 2;

bool is_sum_line(const std::string& line) {
    return line.size() > sum_digits + sum_gap && line.find_first_not_of("0123456789abcdef") == sum_digits &&
           line[sum_digits] == ' ';
}

} // namespace

std::string checksum_of(const std::filesystem::path& file) {
    io::require_regular(file);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw IoError(fmt::format("{}: cannot be read", file.string()));
    }
    Sha256 hash;
    std::vector<char> part(1U << 16U); // more is slower: most files are small
    while (stream.read(part.data(), static_cast<std::streamsize>(part.size())) || stream.gcount() > 0) {
        hash.add({part.data(), static_cast<std::size_t>(stream.gcount())});
    }
    if (stream.bad()) {
        throw IoError(fmt::format("{}: cannot be read to its end; check the disk", file.string()));
    }
    return hash.hex();
}

std::string checksum_of_text(std::string_view text) {
    Sha256 hash;
    hash.add(text);
    return hash.hex();
}

Sums read_sums(const std::filesystem::path& file) {
    io::require_regular(file);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw IoError(fmt::format("{}: cannot be read", file.string()));
    }
    Sums sums;
    for (std::string line; std::getline(stream, line);) {
        if (!is_sum_line(line)) {
            throw IoError(fmt::format("{}: has a line that is no checksum; it was changed or damaged", file.string()));
        }
        sums[line.substr(sum_digits + sum_gap)] = line.substr(0, sum_digits);
    }
    return sums;
}

std::string sums_text(const Sums& sums) {
    std::string text;
    for (const auto& [name, sum] : sums) {
        text += fmt::format("{}  {}\n", sum, name);
    }
    return text;
}

std::string describe_damage(const std::filesystem::path& file, const std::string& sum, const ChecksumOf& now) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        return "is missing";
    }
    return now(file) == sum ? "" : "was changed";
}

} // namespace suffuse::record
