#pragma once
// Text into HTML: everything that comes from a case, a file or a run is escaped here, so that it stays text.

#include "suffuse/report/table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::report {

/// Safe as the content of an element and inside a double-quoted attribute.
std::string escaped(std::string_view text);

/// A table whose first row is the header; `numeric[c]` says which columns are set flush right.
std::string html_table(
    const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
    const std::vector<bool>& numeric, std::string_view css_class
);

/// The numbers of a figure, at most `most_rows` of them, to six digits.
std::string html_table(const Table& table, std::size_t most_rows);

} // namespace suffuse::report
