#pragma once
// The record of a laboratory test: what was understood of it.

#include "apps/console.hpp"
#include <string>
#include <vector>

namespace suffuse::apps {

inline constexpr const char* packing_kind = "packing";

/// "packing" and the kinds of tests.
std::vector<std::string> kinds_of_files();

/// Prints columns with their roles, units and ranges, what decided and what was assumed.
/// @param contraction "positive", "negative" or empty
/// @return the exit code. @throws UsageError, CaseError, IoError.
int import_test(
    const std::string& file, const std::string& kind, const std::string& contraction, const Console& console
);

} // namespace suffuse::apps
