#include "suffuse/gradings/plain_titles.hpp"

#include "suffuse/gradings/lexicon.hpp"
#include "suffuse/gradings/sheet_header.hpp"

#include <algorithm>
#include <set>

namespace suffuse::gradings {

std::string plain_name_above(const Sheet& sheet, std::size_t first, std::size_t header) {
    if (header <= first || sheet.rows[header - 1].is_comment || sheet.rows[header - 1].cells.size() != 1) {
        return {};
    }
    const std::string& text = sheet.rows[header - 1].cells.front().text;
    const Heading heading = read_heading(text);
    const std::string words = spaced_words(text);
    const bool has_number = text.find_first_of("0123456789") != std::string::npos;
    const bool has_letter = words.size() > 3 && words[words.size() - 3] == ' ';
    const bool is_other = heading.kind != ColumnKind::Other || heading.scale != SizeScale::Unknown ||
                          heading.unit != ShareUnit::Unknown || mentions(Topic::Part, words) ||
                          text.find_first_of("<>:=") != std::string::npos || names_hydrometer(sheet.rows[header - 1]);
    return !is_other && (has_number || has_letter) ? text : "";
}

void take_plain_names(const std::vector<std::string>& titles, std::vector<SheetTable>& tables) {
    const std::set<std::string> different(titles.begin(), titles.end());
    const bool have_none = std::ranges::all_of(tables, [](const SheetTable& table) { return table.name.empty(); });
    if (tables.size() > 1 && titles.size() == tables.size() && different.size() == titles.size() &&
        !different.contains("") && have_none) {
        for (std::size_t k = 0; k < tables.size(); ++k) {
            tables[k].name = titles[k];
        }
    }
}

} // namespace suffuse::gradings
