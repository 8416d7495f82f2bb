#include "suffuse/atlas/row.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <string>
#include <system_error>

namespace suffuse::atlas {
namespace {

/// The cells of one line by the names of their columns.
class Cells {
public:
    Cells(const std::vector<std::string_view>& names, const std::vector<std::string_view>& cells, std::size_t line)
        : line_(line) {
        if (cells.size() != names.size()) {
            throw CaseError(fmt::format("atlas, line {}: expected {} cells, found {}", line, names.size(), cells.size())
            );
        }
        for (std::size_t k = 0; k < names.size(); ++k) {
            cells_[names[k]] = cells[k];
        }
    }

    [[nodiscard]] std::string_view text(std::string_view name) const {
        const auto found = cells_.find(name);
        if (found == cells_.end()) {
            throw CaseError(fmt::format("atlas: there is no column {}", name));
        }
        return found->second;
    }

    /// Nothing for nan.
    [[nodiscard]] std::optional<double> optional(std::string_view name) const {
        const std::string_view cell = text(name);
        double value = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (error != std::errc() || end != cell.data() + cell.size()) {
            throw CaseError(fmt::format("atlas, line {}: {} = {} is not a number", line_, name, cell));
        }
        return std::isnan(value) ? std::nullopt : std::optional(value);
    }

    [[nodiscard]] double number(std::string_view name) const {
        const std::optional<double> value = optional(name);
        if (!value) {
            throw CaseError(fmt::format("atlas, line {}: {} has no number", line_, name));
        }
        return *value;
    }

    [[nodiscard]] Threshold threshold(const std::string& name) const {
        return {optional(name), number(name + "_at_most") != 0};
    }

    /// That of `words` whose name the cell has.
    template <class Word>
    [[nodiscard]] Word one_of(std::string_view name, std::initializer_list<Word> words) const {
        for (const Word word : words) {
            if (text(name) == name_of(word)) {
                return word;
            }
        }
        throw CaseError(fmt::format("atlas, line {}: {} = {} is not known", line_, name, text(name)));
    }

private:
    std::map<std::string_view, std::string_view> cells_;
    std::size_t line_;
};

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

Row row_of(const Cells& cells) {
    Row row;
    row.size_ratio = cells.number("ratio");
    row.fines_content = cells.number("fines");
    row.seed = static_cast<int>(cells.number("seed"));
    row.density = cells.one_of("density", {Density::Loose, Density::Medium, Density::Dense});
    row.flow = cells.one_of("flow", {Flow::Up, Flow::Level});
    row.grains = static_cast<std::int64_t>(cells.number("grains"));
    row.porosity = cells.number("porosity");
    row.alpha = cells.number("alpha");
    row.heave = cells.optional("i_c");
    row.moves_1 = cells.threshold("i1");
    row.moves_10 = cells.threshold("i10");
    row.moves_50 = cells.threshold("i50");
    row.drag_share = cells.number("drag_share");
    row.load_bearing = cells.number("load_bearing");
    row.sifting = cells.number("sifting");
    return row;
}

} // namespace

const char* name_of(Density density) {
    switch (density) {
    case Density::Loose:
        return "loose";
    case Density::Medium:
        return "medium";
    case Density::Dense:
        break;
    }
    return "dense";
}

const char* name_of(Flow flow) {
    return flow == Flow::Up ? "up" : "level";
}

double heave_gradient(const Row& row) {
    constexpr double buoyant = 1.65; // Gs - 1
    return row.heave.value_or(buoyant * (1 - row.porosity));
}

std::vector<Row> parse_rows(std::string_view csv) {
    const std::vector<std::string_view> lines = split(csv, '\n');
    const std::vector<std::string_view> names = split(lines.front(), ',');
    std::vector<Row> rows;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        if (!lines[k].empty()) {
            rows.push_back(row_of({names, split(lines[k], ','), k + 1}));
        }
    }
    return rows;
}

const std::vector<Row>& shipped_rows() {
    static const std::vector<Row> rows = parse_rows(shipped_table());
    return rows;
}

} // namespace suffuse::atlas
