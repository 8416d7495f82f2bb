#pragma once
// Text into HTML: everything that comes from a case, a file or a run is escaped here, so that it stays text.

#include "suffuse/base/escaped.hpp"
#include "suffuse/figures/table.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace suffuse::report {

/// Escaped text with the indices of the symbols in this report's words set low: e_min, e_g, e_eq, FC_active,
/// FC_threshold, i_c. A name of the user's with an underscore stays as it is.
std::string with_indices(std::string html);

/// Text of ours or of the run, set for reading: escaped, numbers kept with their units, indices low, what stands in
/// backticks as code.
std::string typeset(const std::string& text);

/// An unordered list of such texts.
std::string html_list(const std::vector<std::string>& lines, std::string_view css_class);

/// A number as people write it: "5.6 × 10⁻¹¹" for what C++ writes as 5.6e-11, a true minus, and no -0.
std::string in_figures(double value, int digits);

/// A table whose first row is the header; `numeric[c]` says which columns are set flush right. Long ones may break
/// over pages of paper. @param caption HTML
std::string html_table(
    const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
    const std::vector<bool>& numeric, std::string_view css_class, std::string_view caption = {}
);

/// The numbers of a figure, at most `most_rows` of them, to six digits.
std::string html_table(const figures::Table& table, std::size_t most_rows);

} // namespace suffuse::report
