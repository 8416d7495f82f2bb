#pragma once
// One screen on anything that has a name: a key of a case, a code, the conventions, a figure, a finding,
// a criterion of stability.

#include <string>
#include <vector>

namespace suffuse::job {

/// @throws UsageError for a word that is not known, with the nearest that is.
std::string explain_word(const std::string& word);

/// All that is known by its own name.
std::vector<std::string> explained_words();

} // namespace suffuse::job
