#include "suffuse/io/csv_table.hpp"

#include <algorithm>
#include <string_view>

namespace suffuse::io {

namespace {

constexpr std::string_view blanks = " \t\r";

int count_characters(std::string_view text) {
    return static_cast<int>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

/// The first of these outside of quotes.
std::size_t find_outside_quotes(std::string_view text, std::string_view marks, std::size_t begin = 0) {
    bool is_quoted = false;
    for (std::size_t k = begin; k < text.size(); ++k) {
        is_quoted = is_quoted != (text[k] == '"');
        if (!is_quoted && marks.find(text[k]) != std::string_view::npos) {
            return k;
        }
    }
    return text.size();
}

CsvRow split_line(const std::shared_ptr<const Source>& source, std::string_view line, int number, char mark) {
    CsvRow row;
    row.place = {source, number, 1, std::max(1, count_characters(line))};
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = find_outside_quotes(line, std::string_view(&mark, 1), begin);
        std::string_view text = trimmed(line.substr(begin, end - begin));
        const auto first = static_cast<std::size_t>(text.data() - line.data());
        const Place place{
            source, number, count_characters(line.substr(0, first)) + 1, std::max(1, count_characters(text))};
        if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
            text = trimmed(text.substr(1, text.size() - 2));
        }
        row.cells.push_back({std::string(text), place});
        begin = end + 1;
    }
    return row;
}

} // namespace

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

CsvTable split_rows(const std::shared_ptr<const Source>& source) {
    CsvTable table;
    int number = 0;
    const std::string_view text = source->text;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = text.substr(begin, end - begin);
        begin = end + 1;
        ++number;
        line = line.substr(0, find_outside_quotes(line, "#"));
        line = line.substr(0, line.find_last_not_of(" \r") + 1);
        if (line.find_first_not_of(" \t;,\"") == std::string_view::npos) { // the empty rows of a sheet have marks
            continue;
        }
        if (table.rows.empty()) {
            const std::size_t found = find_outside_quotes(line, ";\t");
            table.mark = found < line.size() ? line[found] : ',';
        }
        table.rows.push_back(split_line(source, line, number, table.mark));
        std::vector<CsvCell>& cells = table.rows.back().cells;
        const std::size_t columns = table.rows.front().cells.size();
        while (cells.size() > 1 && cells.back().text.empty() && (table.rows.size() == 1 || cells.size() > columns)) {
            cells.pop_back();
        }
    }
    return table;
}

} // namespace suffuse::io
