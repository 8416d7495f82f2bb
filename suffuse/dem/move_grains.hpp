#pragma once
// Phases 5 and 6 of the step in one pass over the grains: sum of contact forces in a fixed order, then the motion.

#include "suffuse/dem/step.hpp"
#include "suffuse/motion/integrator.hpp"

namespace suffuse::dem {

/// Writes force and torque of every grain and moves it.
/// @return the largest motion of a grain against the mean motion since the contact table was made [m].
double move_grains(
    const motion::StepMotion& step, const StepCaches& caches, const grains::GrainLoad* load, double load_share,
    const Mat3& h, grains::Grains& grains
);

} // namespace suffuse::dem
