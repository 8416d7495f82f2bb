#pragma once
// Data of the page in few bytes: browsers unpack them again (DecompressionStream, page/src/unpack.js).

#include <string>
#include <string_view>

namespace suffuse::report {

/// zlib's format [RFC 1950], the same bytes for the same input.
std::string deflated(std::string_view bytes);

/// Deflated, as base64: may stand in any element.
std::string packed(std::string_view text);

} // namespace suffuse::report
