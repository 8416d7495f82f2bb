#pragma once
// The numbers of a state that every stage reports. Their names are a promise to users' scripts.

#include "suffuse/dem/world.hpp"
#include "suffuse/triaxial/response.hpp"
#include "suffuse/triaxial/stiffness.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace suffuse::run {

/// Overlap over the smaller radius [-] from which a stage is warned of, and beyond which its results are marked. Hard
/// shearing presses single fines far into their neighbors at the usual stiffness; beyond a fifth the linear law is no
/// model of a contact any more.
inline constexpr double notable_overlap = 0.1, largest_good_overlap = 0.2;

/// What is to be said of a largest overlap over the smaller radius, with the modulus that would have kept it small;
/// empty where it is below `notable` [-].
std::string words_on_overlap(double ratio, const grains::Material& material, double notable = notable_overlap);

/// What is to be said of a test that held its stress less closely than a quasi-static one does, with what to do; empty
/// where it did, and where the sample lost that stress, which is said elsewhere.
std::string words_on_hold(const std::vector<triaxial::PathRow>& rows, const triaxial::TriaxialSpec& spec);

/// What is to be said of a stiffness that is not the elastic one; empty where it is.
std::string words_on_stiffness(const triaxial::Stiffness& stiffness, const triaxial::StiffnessSpec& spec);

/// Grains, contacts, cell, stress, density, coordination, fabric, forces, balance, hash; with fines in the sample also
/// what they do.
/// @param has_fractions the soil has a coarse and a fine part, also where this sample has one of them only: the ends of
/// a sweep over the fines content belong to its curves
nlohmann::json measure_state(const dem::World& world, bool has_fractions = false);

} // namespace suffuse::run
