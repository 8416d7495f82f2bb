#pragma once
// Special fields of stages that probe fines, with weight or without: gradients, and what changes from pass to pass.

#include "suffuse/casefile/reader.hpp"
#include "suffuse/casefile/special_fields.hpp"
#include "suffuse/casefile/writer.hpp"

namespace suffuse::casefile {

template <class V>
void fields(V& v, erosion::DetachSpec& s) {
    v.choice("by", s.by, names::detach_by);
    velocity_rule_field(v, s);
    over_field(v, s);
    v.field("noise_quantile", s.noise_quantile);
}

/// The case's [gravity] belongs to every stage that probes fines or moves them.
void take_gravity(Reader& v, std::optional<erosion::Gravity>& gravity);

inline void take_gravity(Writer&, const std::optional<erosion::Gravity>&) {}

/// Keys that have no meaning where fines have weight.
void check_weightless(Reader& v, const erosion::ProbeSpec& probe);

inline void check_weightless(Writer&, const erosion::ProbeSpec&) {}

/// Keys that have no meaning where fines have no weight.
void check_weighed(Reader& v, const erosion::ProbeSpec& probe);

inline void check_weighed(Writer&, const erosion::ProbeSpec&) {}

/// Where nothing is held all fines of weight fall. @param holds_coarse in every pass
void check_hold(Reader& v, const erosion::ProbeSpec& probe, bool holds_coarse);

inline void check_hold(Writer&, const erosion::ProbeSpec&, bool) {}

/// Fines do not migrate without weight.
void check_migration(Reader& v, const erosion::MigrateSpec& s);

inline void check_migration(Writer&, const erosion::MigrateSpec&) {}

/// A list, or { up_to = 1.2, steps = 24 }.
void gradients_field(Reader& v, erosion::DetachStageSpec& s);
void gradients_field(Writer& v, const erosion::DetachStageSpec& s);

/// With weight the gradients rise; without it none is requested.
void check_ramp(Reader& v, const erosion::DetachStageSpec& s);

inline void check_ramp(Writer&, const erosion::DetachStageSpec&) {}

/// `gradient`, `hold` and `detached`, each a value or a list with one a pass. They are read together, and written where
/// they have always been.
void gradient_of_passes(Reader& v, erosion::ErodeSpec& s);

inline void hold_of_passes(Reader&, const erosion::ErodeSpec&) {}

inline void rule_of_passes(Reader&, const erosion::ErodeSpec&) {}

void gradient_of_passes(Writer& v, const erosion::ErodeSpec& s);
void hold_of_passes(Writer& v, const erosion::ErodeSpec& s);
void rule_of_passes(Writer& v, const erosion::ErodeSpec& s);

} // namespace suffuse::casefile
