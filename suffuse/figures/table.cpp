#include "suffuse/figures/table.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/facts/shown.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::figures {

namespace {

std::size_t length(const Column& column) {
    return std::visit([](const auto& values) { return values.size(); }, column.values);
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char letter : text) {
        if (letter == '"') {
            out += '"';
        }
        out += letter;
    }
    return out + '"';
}

std::string on_one_line(std::string text) {
    for (char& letter : text) {
        if (letter == '\n' || letter == '\r') {
            letter = ' ';
        }
    }
    return text;
}

template <class Value>
const std::vector<Value>& values_of(const std::vector<Column>& columns, const std::string& name) {
    for (const Column& column : columns) {
        const auto* values = std::get_if<std::vector<Value>>(&column.values);
        if (column.name == name && values != nullptr) {
            return *values;
        }
    }
    throw Bug("no such column of a table: " + name);
}

} // namespace

void Table::add(std::string name, std::string unit, std::vector<double> values) {
    add_column({std::move(name), std::move(unit), std::move(values)});
}

void Table::add_fact(const std::string& key, std::vector<double> values) {
    for (double& value : values) {
        value = facts::in_unit_shown(key, value);
    }
    add(key, std::string(facts::unit_shown(key)), std::move(values));
}

void Table::add(std::string name, std::vector<std::string> words) {
    add_column({std::move(name), "", std::move(words)});
}

void Table::add_column(Column column) {
    expects(columns_.empty() || length(column) == rows(), "the columns of a table have one length");
    columns_.push_back(std::move(column));
}

std::size_t Table::rows() const {
    return columns_.empty() ? 0 : length(columns_.front());
}

std::string Table::cell(std::size_t row, std::size_t column, int digits) const {
    const Column& c = columns_.at(column);
    if (const auto* words = std::get_if<std::vector<std::string>>(&c.values)) {
        return words->at(row);
    }
    const double value = std::get<std::vector<double>>(c.values).at(row);
    if (!std::isfinite(value)) {
        return "";
    }
    return digits > 0 ? fmt::format("{:.{}g}", value, digits) : fmt::format("{}", value);
}

const std::vector<double>& Table::numbers(const std::string& name) const {
    return values_of<double>(columns_, name);
}

const std::vector<std::string>& Table::words(const std::string& name) const {
    return values_of<std::string>(columns_, name);
}

std::string heading(const Column& column) {
    return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
}

std::string to_csv(const Table& table, const std::vector<std::pair<std::string, std::string>>& remarks) {
    std::string out;
    for (const auto& [key, value] : remarks) {
        out += "# " + on_one_line(key) + ": " + on_one_line(value) + "\n";
    }
    for (std::size_t column = 0; column < table.columns().size(); ++column) {
        if (column > 0) {
            out += ',';
        }
        out += quoted(heading(table.columns()[column]));
    }
    out += "\n";
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (std::size_t column = 0; column < table.columns().size(); ++column) {
            if (column > 0) {
                out += ',';
            }
            out += quoted(table.cell(row, column));
        }
        out += "\n";
    }
    return out;
}

} // namespace suffuse::figures
