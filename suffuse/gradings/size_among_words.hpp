#pragma once
// A size within words of what passes it.

#include <string>
#include <string_view>

namespace suffuse::gradings {

/// The longest part of the text that is a size, as in "% passing #4" and "Passing 0.075 mm (%)"; empty where nothing is
/// said to pass, or no size.
std::string size_among_words(std::string_view text);

} // namespace suffuse::gradings
