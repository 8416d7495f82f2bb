#include "suffuse/dem/carried_stress.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/inspect.hpp"

#include <fmt/format.h>

namespace suffuse::dem {

double require_pressure(const Mat3& stress, std::string_view who_needs_it) {
    const double pressure = mean_stress(stress);
    if (!(pressure > 0)) {
        throw StateError(fmt::format(
            "{} that carries a stress, but the mean stress of this one is {:.4g} kPa: compact or settle it under a "
            "pressure first",
            who_needs_it, pressure / 1e3
        ));
    }
    return pressure;
}

} // namespace suffuse::dem
