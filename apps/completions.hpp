#pragma once
// Completions for shells, made from the table of verbs and flags.

#include "apps/command_table.hpp"
#include <string>
#include <vector>

namespace suffuse::apps {

/// A script for `shell`: bash, zsh or fish. @throws UsageError for another.
std::string completions_for(const std::string& shell, const std::vector<VerbRow>& table);

} // namespace suffuse::apps
