#pragma once
// Under which loading a stage ends in balance, where it names one.

#include "suffuse/casefile/case.hpp"

#include <optional>

namespace suffuse::casefile {

std::optional<cell::Loading> loading_at_end(const StageSpec& spec);

} // namespace suffuse::casefile
