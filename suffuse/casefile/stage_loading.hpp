#pragma once
// Under which loading a stage ends in balance, where it names one.

#include "suffuse/casefile/case.hpp"

#include <optional>

namespace suffuse::casefile {

std::optional<cell::Loading> loading_at_end(const StageSpec& spec);

/// Whether it is a compaction that keeps the shear stresses between the axes, and could release them by its key.
bool could_release_shear(const StageSpec& spec);

} // namespace suffuse::casefile
