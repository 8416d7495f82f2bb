#include "suffuse/report/warnings.hpp"

#include "suffuse/base/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace suffuse::report {

namespace {

/// A warning taken apart: words[0] number[0] words[1] number[1] ... words.back().
struct Warning {
    std::string where;
    std::vector<std::string> words = {""}, numbers;
};

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

Warning taken_apart(const std::string& line) {
    Warning warning;
    const std::size_t colon = line.find(": ");
    const bool has_place = colon != std::string::npos && line.find(' ') > colon;
    warning.where = has_place ? line.substr(0, colon) : "";
    std::size_t k = has_place ? colon : 0;
    while (k < line.size()) {
        if (!is_digit(line[k]) || (k > 0 && is_word(line[k - 1]))) {
            warning.words.back() += line[k++];
            continue;
        }
        const std::size_t begin = k;
        while (k < line.size() &&
               (is_digit(line[k]) || (line[k] == '.' && k + 1 < line.size() && is_digit(line[k + 1])))) {
            ++k;
        }
        if (k + 2 < line.size() && line[k] == 'e' && (line[k + 1] == '-' || line[k + 1] == '+')) {
            for (k += 2; k < line.size() && is_digit(line[k]);) {
                ++k;
            }
        }
        warning.numbers.push_back(line.substr(begin, k - begin));
        warning.words.emplace_back();
    }
    return warning;
}

double value(const std::string& number) {
    return std::strtod(number.c_str(), nullptr);
}

std::string merged(const std::vector<Warning>& alike) {
    const std::size_t numbers = alike.front().numbers.size();
    std::string text = alike.front().words[0], most;
    for (std::size_t n = 0; n < numbers; ++n) {
        const auto [low, high] = std::minmax_element(alike.begin(), alike.end(), [n](const auto& a, const auto& b) {
            return value(a.numbers[n]) < value(b.numbers[n]);
        });
        const bool varies = value(low->numbers[n]) < value(high->numbers[n]);
        if (varies && most.empty()) {
            most = high->where;
        }
        text += low->numbers[n] + (varies ? " to " + high->numbers[n] : "") + alike.front().words[n + 1];
    }
    return most.empty() ? fmt::format("{} stages, {} the first{}", alike.size(), alike.front().where, text)
                        : fmt::format("{} stages, {} the most{}", alike.size(), most, text);
}

} // namespace

std::vector<std::string> merged_warnings(const std::vector<std::string>& lines) {
    constexpr std::size_t least = 3;
    std::vector<std::vector<std::size_t>> kinds; // rows of `all`
    std::vector<Warning> all;
    for (const std::string& line : lines) {
        all.push_back(taken_apart(line));
        const auto kind = std::find_if(kinds.begin(), kinds.end(), [&](const auto& rows) {
            const Warning& first = all[rows.front()];
            return !first.where.empty() && !all.back().where.empty() && first.words == all.back().words;
        });
        (kind == kinds.end() ? kinds.emplace_back() : *kind).push_back(all.size() - 1);
    }
    std::vector<std::string> merged_lines;
    for (const std::vector<std::size_t>& rows : kinds) {
        if (rows.size() < least) {
            for (const std::size_t row : rows) {
                merged_lines.push_back(lines[row]);
            }
            continue;
        }
        std::vector<Warning> alike;
        for (const std::size_t row : rows) {
            alike.push_back(all[row]);
        }
        merged_lines.push_back(merged(alike));
    }
    return merged_lines;
}

} // namespace suffuse::report
