#pragma once
// Which program made a result.

#include <string>

namespace suffuse {

std::string version();  ///< of the project, in CMakeLists.txt
std::string commit();   ///< short hash of the source, "-dirty" where it was changed; "unknown" outside a checkout
std::string compiler(); ///< "g++ 12.2.0, Release"

} // namespace suffuse
