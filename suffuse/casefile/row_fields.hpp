#pragma once
// `rows` of a study: sets of values that belong together, as parameters of one sample of a posterior do. A table of
// lists as a sweep has them, or a CSV file whose headings are its keys. The sweep has a key "row", from 1, that
// chooses.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/writer.hpp"

#include <map>
#include <string>

namespace suffuse::casefile {

/// The key of a sweep that chooses among rows.
inline constexpr const char* row_key = "row";

/// Reads them, and sweeps over all rows unless the sweep of the study, which has been read, says which.
void rows_field(Reader& v, Study& study);
void rows_field(Writer& v, const Study& study);

/// Values of the row that `values` chooses, by their keys; none where the study has no rows.
std::map<std::string, Scalar> values_of_row(const Study& study, const std::map<std::string, Scalar>& values);

} // namespace suffuse::casefile
