#pragma once
// The text of a table as a laboratory sends it: UTF-8, UTF-16 with its byte order mark, or Windows-1252, with whatever
// ends its lines. What is no text, a workbook above all, is named as what it is.

#include "suffuse/base/diagnostics.hpp"

#include <memory>

namespace suffuse::gradings {

/// The same source in UTF-8, each line ended by \n; empty where it is no text, which is reported. That it was
/// Windows-1252 is a remark.
std::shared_ptr<const Source> decode_sheet(const std::shared_ptr<const Source>& source, Problems& problems);

} // namespace suffuse::gradings
