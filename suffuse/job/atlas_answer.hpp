#pragma once
// What the atlas of simulated soils says of a soil that has two parts: the gradients that move its fines, for every
// density and flow that the atlas has.

#include "suffuse/atlas/interpolation_error.hpp"
#include "suffuse/atlas/look_up.hpp"
#include "suffuse/stability/assess.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

/// The two parts of a curve.
struct TwoParts {
    double finer_than = 0; ///< where the curve is split [m]
    std::string reason;    ///< why there
    double size_ratio = 0, fines_content = 0;
    std::optional<double> fines_width; ///< D90/D10 of the fines; none: not measured [-]

    /// Whether the atlas, whose fines have nearly equal sizes, has gradients that are too high for them
    /// (validation/surrogate.md: by 28 to 38 % where the fines were a factor of 3 to 4 wide).
    [[nodiscard]] bool has_wide_fines() const {
        constexpr double wide = 2.2; // between factors of 2.5 and 3
        return fines_width.value_or(wide) >= wide;
    }
};

/// One flow, and how well the atlas interpolates in it.
struct AtlasFlow {
    atlas::Flow flow = atlas::Flow::Up;
    std::vector<atlas::Found> of_density;
    atlas::InterpolationError error;
};

struct AtlasAnswer {
    std::optional<TwoParts> parts; ///< none: no split is unstable, or the curve does not reach the middle of both parts
    std::string no_parts;          ///< why
    std::vector<AtlasFlow> flows;  ///< those of the seepage, both where it does not say; none is downward
    std::string extent;            ///< of the atlas: "D50/d50 6.5 and 5 to 15 % of fines"
};

/// @param spec where the fines begin and which way the water goes, if it says so
AtlasAnswer consult_atlas(
    const grains::Grading& measured, const stability::AssessSpec& spec,
    const std::vector<atlas::Row>& rows = atlas::shipped_rows()
);

/// An object for each density and flow; the names are a promise (docs/formats.md).
nlohmann::json atlas_json(const AtlasAnswer& answer, const stability::AssessSpec& spec);

} // namespace suffuse::job
