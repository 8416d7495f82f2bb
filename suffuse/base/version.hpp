#pragma once
// Which program made a result.

#include <string>

namespace suffuse {

std::string version();  ///< "0.1.0"
std::string commit();   ///< short hash of the source, "-dirty" where it was changed; "unknown" outside a checkout
std::string compiler(); ///< "g++ 12.2.0, Release"

} // namespace suffuse
