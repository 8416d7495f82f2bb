#pragma once
// A case as Python holds it: what was read, and how.

#include "suffuse/casefile/load_case.hpp"

#include <filesystem>
#include <string>

namespace suffuse::python {

struct CaseHandle {
    std::filesystem::path path;
    std::string text; ///< as given
    casefile::LoadOptions options;
    casefile::LoadedCase loaded;
};

} // namespace suffuse::python
