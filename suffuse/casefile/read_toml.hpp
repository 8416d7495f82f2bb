#pragma once
// TOML text -> the neutral tree. The only room that knows the TOML library.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/casefile/node.hpp"

#include <memory>
#include <optional>

namespace suffuse::casefile {

/// The tree of a file, every node with its place; empty where the text is no TOML, which is reported.
std::optional<Node> read_toml(const std::shared_ptr<const Source>& source, Problems& problems);

} // namespace suffuse::casefile
