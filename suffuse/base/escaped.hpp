#pragma once
// Text that stays text in HTML and SVG.

#include <string>
#include <string_view>

namespace suffuse {

/// Safe as the content of an element and inside a double-quoted attribute.
std::string escaped(std::string_view text);

} // namespace suffuse
