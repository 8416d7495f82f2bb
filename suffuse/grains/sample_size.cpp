#include "suffuse/grains/sample_size.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::grains {

SampleSize size_sample(const Soil& soil, const SampleSizeSpec& spec) {
    if (!soil.coarse || !soil.fines || !(soil.fines_content >= 0 && soil.fines_content <= 1)) {
        throw CaseError("sample_size: expected a soil of a coarse and a fine grading, with a fines content; give "
                        "`particles` for other soils");
    }
    const double coarse = (1 - soil.fines_content) * grains_per_volume(*soil.coarse); // [1/m3 of solid]
    const double fines = soil.fines_content * grains_per_volume(*soil.fines);
    const bool has_skeleton = soil.fines_content < 1;
    const double counted = has_skeleton ? coarse : fines;
    const double diameter = size_at(has_skeleton ? *soil.coarse : *soil.fines, 0.5);
    const double by_count = static_cast<double>(spec.coarse_grains) / counted; // solid volume [m3]
    const double by_width = std::pow(spec.cell_width * diameter, 3) * (1 - sized_porosity);

    SampleSize size;
    size.rule = by_count <= by_width ? SizedBy::CoarseGrains : SizedBy::CellWidth;
    // The nearest whole number: the sample's own rounding then gives the specified coarse grains.
    size.particles = std::llround(std::min(by_count, by_width) * (coarse + fines));
    if (spec.at_most && size.particles > *spec.at_most) {
        const std::int64_t least = std::llround(static_cast<double>(spec.least_coarse) / counted * (coarse + fines));
        const bool pays = !has_skeleton || least <= *spec.at_most;
        size = pays ? SampleSize{*spec.at_most, SizedBy::AtMost}
                    : SampleSize{std::min(least, size.particles), SizedBy::LeastCoarse};
    }
    if (size.particles < spec.at_least) {
        size = {spec.at_least, SizedBy::AtLeast};
    }
    return size;
}

} // namespace suffuse::grains
