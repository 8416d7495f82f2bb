#pragma once
// Messages that may quote a text of somebody else: a value of a case, a cell of a sheet, a name. However long that is,
// the message stays one that people read.

#include <string>
#include <string_view>

namespace suffuse {

/// The message with long words and long texts between quotation marks cut in their middle: what was there is shown as
/// "…". So are lines that are still long.
std::string readable(std::string_view message);

} // namespace suffuse
