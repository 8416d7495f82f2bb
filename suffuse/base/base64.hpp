#pragma once
// Base64 [RFC 4648]: bytes inside a page or an XML file.

#include <optional>
#include <string>
#include <string_view>

namespace suffuse {

std::string base64(std::string_view bytes);

/// The bytes of a text with line breaks, nothing where it is not base64. Padding ends a group, not the text: VTK
/// encodes lengths and data one after the other.
std::optional<std::string> from_base64(std::string_view text);

} // namespace suffuse
