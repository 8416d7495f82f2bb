#pragma once
// What each criterion of internal stability asks, in words: the text of `suffuse explain CRITERION`.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::stability {

/// One screen on a criterion by its id, "kenney-lau-1986"; on each that a word of ids means, "kezdi", "kenney-lau", or
/// that reads the number asked for, "alpha", "h/f"; nothing where there is none.
std::optional<std::string> explain_criterion(std::string_view word);

/// Ids of all criteria, in the order of the assessment, those of gradients last.
std::vector<std::string> criterion_ids();

} // namespace suffuse::stability
