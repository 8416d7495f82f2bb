#include "suffuse/atlas/table.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

namespace suffuse::atlas {
namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(at);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) {
            return parts;
        }
        text.remove_prefix(end + 1);
    }
}

} // namespace

Cells::Cells(const std::vector<std::string_view>& names, const std::vector<std::string_view>& cells, std::size_t line)
    : line_(line) {
    if (cells.size() != names.size()) {
        throw CaseError(fmt::format("atlas, line {}: expected {} cells, found {}", line, names.size(), cells.size()));
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        cells_[names[k]] = cells[k];
    }
}

std::string_view Cells::text(std::string_view column) const {
    const auto found = cells_.find(column);
    if (found == cells_.end()) {
        throw CaseError(fmt::format("atlas: there is no column {}", column));
    }
    return found->second;
}

std::optional<double> Cells::optional(std::string_view column) const {
    const std::string_view cell = text(column);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size()) {
        throw CaseError(fmt::format("atlas, line {}: {} = {} is not a number", line_, column, cell));
    }
    return std::isnan(value) ? std::nullopt : std::optional(value);
}

double Cells::number(std::string_view column) const {
    const std::optional<double> value = optional(column);
    if (!value) {
        throw CaseError(fmt::format("atlas, line {}: {} has no number", line_, column));
    }
    return *value;
}

std::vector<Cells> parse_table(std::string_view csv) {
    const std::vector<std::string_view> lines = split(csv, '\n');
    const std::vector<std::string_view> names = split(lines.front(), ',');
    std::vector<Cells> rows;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        if (!lines[k].empty()) {
            rows.emplace_back(names, split(lines[k], ','), k + 1);
        }
    }
    return rows;
}

} // namespace suffuse::atlas
