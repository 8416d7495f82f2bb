#pragma once
// The door of this room: a case file -> Case, or all that is wrong with it.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/bind.hpp"
#include "suffuse/casefile/case.hpp"

#include <string>
#include <vector>

namespace suffuse::casefile {

struct LoadOptions {
    std::string preset;                 ///< instead of the one that the case names
    std::vector<std::string> overrides; ///< "study.erosion.particles=4000", applied after the preset
    std::vector<std::string> studies;   ///< these alone; empty: all
};

struct LoadedCase {
    Case value;
    std::vector<Diagnostic> warnings;
};

/// Throws CaseProblems with every problem of the case, or IoError where the file cannot be read.
LoadedCase load_case(const std::string& path, const LoadOptions& options = {});

/// The same for a text that stands in `folder`; `name` is shown in messages.
LoadedCase load_case_text(
    const std::string& text, const std::string& name, const std::string& folder, const LoadOptions& options = {}
);

} // namespace suffuse::casefile
