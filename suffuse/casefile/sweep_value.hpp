#pragma once
// What a value of a sweep is worth, and how it is written. It stays as it stands in the case, a text with its unit:
// folders and tables bear the user's own words.

#include "suffuse/base/units.hpp"
#include "suffuse/casefile/case.hpp"

#include <optional>
#include <string>

namespace suffuse::casefile {

/// The value in SI, with its dimension; nothing for words and flags.
std::optional<Quantity> quantity_of(const Scalar& value);

/// As in the case, a text without its quotation marks.
std::string written(const Scalar& value);

} // namespace suffuse::casefile
