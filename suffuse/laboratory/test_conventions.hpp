#pragma once
// Units and signs of a record that its headings leave open, found out from its numbers: strain_conventions.hpp and
// stress_conventions.hpp say how.

#include "suffuse/laboratory/test_record.hpp"

#include <optional>
#include <string>

namespace suffuse::laboratory {

/// Turns the values of `record` to compression and contraction positive, and notes what decided and what was assumed.
/// @param file for messages
/// @throws CaseError where two readings are possible, with both, and where columns contradict one another.
void find_conventions(TestRecord& record, const std::string& file, std::optional<bool> contraction_is_positive);

} // namespace suffuse::laboratory
