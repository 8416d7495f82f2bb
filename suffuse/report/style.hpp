#pragma once
// The report's look, also for print and dark screens: page/src/style.css, embedded when the library is built.

#include <string_view>

namespace suffuse::report {

/// CSS.
std::string_view page_style();

} // namespace suffuse::report
