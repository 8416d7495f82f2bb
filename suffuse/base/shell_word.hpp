#pragma once

#include <string>

namespace suffuse {

/// A word for a shell, in quotes where it needs them.
std::string shell_word(const std::string& word);

} // namespace suffuse
