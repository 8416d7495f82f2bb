#pragma once
// The tree of a case file -> Case, and back.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/case.hpp"
#include "suffuse/casefile/node.hpp"

#include <string>

namespace suffuse::casefile {

/// Reads the whole tree and reports all its problems; what failed keeps its default. `folder` is where the case's
/// relative paths start, `preset` the name of the one that was applied.
Case bind_case(const Node& root, const std::string& folder, const std::string& preset, Problems& problems);

/// The tree of a case with every default spelled out.
Node tree_of(const Case& c);

/// The case as a file with every default and unit spelled out, gradings included; reading it gives the same case.
std::string resolved_toml(const Case& c);

} // namespace suffuse::casefile
