#pragma once
// Amounts of memory with their unit: "16GB" -> 1.6e10. Decimal (kB, MB, GB, TB) or binary (KiB, MiB, GiB, TiB).

#include <string_view>

namespace suffuse {

/// [B]. Throws UnitError: no positive number, no unit, or an unknown one.
double parse_byte_size(std::string_view text);

} // namespace suffuse
