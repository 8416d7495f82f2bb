#pragma once
// Which stage a file is of: its key is one for all that decides the numbers of a stage in the case. A file with another
// key is of another case, sample, stage or seed. By which program it was computed is kept apart from the key.

#include "suffuse/casefile/case.hpp"

#include <string>

namespace suffuse::record {

/// "FORM:KEY" in hexadecimal digits: KEY is the SHA-256 of the stage's settings, of the sample and the seed, and of the
/// state that the stage starts from; names have no part in it. FORM stands for the keys and defaults that cases have:
/// keys of two forms cannot be compared.
/// @param start_state as stage.json has it; empty where the stage makes its own sample
std::string key_of_stage(
    const casefile::Case& what, const casefile::Variant& variant, const casefile::Stage& stage,
    const std::string& start_state
);

enum class SameStage {
    Yes,
    No,
    Unknown, ///< there is no key, or one of another form: an earlier version wrote it
};

SameStage compare_keys(const std::string& found, const std::string& expected);

} // namespace suffuse::record
