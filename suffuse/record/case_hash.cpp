#include "suffuse/record/case_hash.hpp"

#include "suffuse/base/state_hash.hpp"
#include "suffuse/casefile/bind.hpp"

#include <fmt/format.h>

#include <string_view>

namespace suffuse::record {

std::string case_hash(const casefile::Case& what) {
    StateHash hash;
    const std::string resolved = casefile::resolved_toml(what);
    hash.add(std::string_view(resolved)); // its characters, not where they lie
    return fmt::format("{:016x}", hash.value());
}

} // namespace suffuse::record
