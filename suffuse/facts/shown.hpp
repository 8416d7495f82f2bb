#pragma once
// Numbers as people read them: the heads of tables, the titles of axes, and values in their units.

#include <string>
#include <string_view>

namespace suffuse::facts {

/// "mean stress p [kPa]" of "mean_stress". @throws Bug for a key whose fact gives no name, as do those below
std::string title(std::string_view key);

/// "p [kPa]", where there is no room for more.
std::string short_title(std::string_view key);

/// "kPa".
std::string_view unit_shown(std::string_view key);

/// Significant digits.
int digits_shown(std::string_view key);

/// A value, given in the unit of files, in the unit shown: 99.8 of 99800 Pa.
double in_unit_shown(std::string_view key, double value);

/// "99.8", with the digits of the fact; a dash where there is no number.
std::string text_shown(std::string_view key, double value);

} // namespace suffuse::facts
