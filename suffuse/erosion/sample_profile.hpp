#pragma once
// Porosity, fines and permeability along the flow, in slices across it. The same water goes through all slices, and
// spends in each its discharge times the slice's head: so that head is the power of the slice's throats over the
// discharge, and heads add up to that of the sample exactly.

#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/migration_result.hpp"
#include "suffuse/flow/seepage.hpp"

#include <cstddef>
#include <vector>

namespace suffuse::erosion {

/// Slices of about half of the largest coarse grain, from where the water enters the cell; none where a plane across
/// the flow cuts the periodic cell at an angle.
SampleProfile begin_sample_profile(const dem::World& world, const Vec3& direction);

/// Adds what the slices are now. @param seepage of grains of this world, at any gradient along the direction
void note_sample_profile(
    const dem::World& world, const flow::Seepage& seepage, const Vec3& direction, SampleProfile& profile
);

/// Share of the flow's power that each of `count` slices of a period takes: its head over that of the sample [-].
std::vector<double> head_shares(const flow::Seepage& seepage, const Vec3& direction, double length, std::size_t count);

} // namespace suffuse::erosion
