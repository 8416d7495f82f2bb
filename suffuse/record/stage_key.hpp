#pragma once
// Which stage a file is of: its key is one for all that decides the numbers of a stage in the case. A file with another
// key is of another case, sample, stage or seed. By which program it was computed is kept apart from the key.

#include "suffuse/casefile/case.hpp"
#include "suffuse/record/sums.hpp"

#include <string>

namespace suffuse::record {

/// Of stage.json: sums_of_imported.
inline constexpr const char* imported_files_key = "imported_files";

/// Of the files that an import reads: "packing", and "contacts" where it has one. Other stages read none.
Sums sums_of_imported(const casefile::Stage& stage);

/// "FORM:KEY" in hexadecimal digits: KEY is the SHA-256 of the stage's settings, of the sample and the seed, of the
/// files that it imports, and of the state that it starts from; its name has no part in it. FORM stands for the
/// keys and defaults that cases have: keys of two forms cannot be compared.
/// @param start_state as stage.json has it; empty where the stage makes its own sample
/// @param imported sums_of_imported, as stage.json has them: the files may be others by now; an earlier version left
/// none
std::string key_of_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage,
    const std::string& start_state, const Sums& imported = {}
);

enum class SameStage {
    Yes,
    No,
    Unknown, ///< there is no key, or one of another form: an earlier version wrote it
};

SameStage compare_keys(const std::string& found, const std::string& expected);

} // namespace suffuse::record
