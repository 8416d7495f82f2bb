#include "suffuse/run/assumed_values.hpp"

#include <algorithm>
#include <string>

namespace suffuse::run {
namespace {

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string_view::npos ? std::string{} : std::string(text.substr(first, last - first + 1));
}

/// The name between the brackets of a table's header; empty for other lines.
std::string table_name(const std::string& line) {
    if (!line.starts_with('[')) {
        return {};
    }
    const std::size_t begin = line.find_first_not_of('['), end = line.find(']');
    return begin == std::string::npos || end == std::string::npos || end < begin ? std::string{}
                                                                                 : line.substr(begin, end - begin);
}

std::string full_key(const std::string& table, const std::string& stage, const std::string& key) {
    constexpr std::string_view of_stage = ".stage";
    if (table.ends_with(of_stage)) {
        const std::string study = table.substr(0, table.size() - of_stage.size());
        return study + (stage.empty() ? "" : ", stage " + stage) + ": " + key;
    }
    return table.empty() ? key : table + "." + key;
}

} // namespace

std::vector<report::AssumedValue> assumed_values(std::string_view case_text) {
    std::vector<report::AssumedValue> values;
    std::string table, stage;
    for (std::size_t at = 0; at < case_text.size();) {
        const std::size_t end = std::min(case_text.find('\n', at), case_text.size());
        const std::string line = trimmed(case_text.substr(at, end - at));
        at = end + 1;
        if (const std::string name = table_name(line); !name.empty()) {
            table = name;
            stage.clear();
            continue;
        }
        const std::size_t mark = line.find("#~"), equals = line.find('=');
        if (equals == std::string::npos || line.starts_with('#')) {
            continue;
        }
        const std::string key = trimmed(std::string_view(line).substr(0, equals));
        if (key == "name") {
            const std::size_t open = line.find('"', equals), close = line.find('"', open + 1);
            stage = close == std::string::npos ? std::string{} : line.substr(open + 1, close - open - 1);
        }
        if (mark == std::string::npos || mark < equals) {
            continue;
        }
        values.push_back(
            {full_key(table, stage, key), trimmed(std::string_view(line).substr(equals + 1, mark - equals - 1)),
             trimmed(std::string_view(line).substr(mark + 2))}
        );
    }
    return values;
}

} // namespace suffuse::run
