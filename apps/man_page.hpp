#pragma once
// The man page, made from the table of verbs and flags.

#include "apps/command_table.hpp"
#include <string>
#include <vector>

namespace suffuse::apps {

/// suffuse(1) in the man macros of roff.
std::string man_page(const std::vector<VerbRow>& table);

} // namespace suffuse::apps
