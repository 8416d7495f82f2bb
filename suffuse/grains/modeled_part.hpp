#pragma once
// Which part of a grading a sample of limited size can stand for. Grains of one mass number as 1/d^3: a hundredfold
// range of sizes takes millions of grains before a few of the coarsest are among them.

#include "suffuse/grains/soil.hpp"

#include <optional>

namespace suffuse::grains {

/// What a sample needs before it shows how fines leave a skeleton.
struct Representative {
    double tolerance = 0.02;         ///< largest difference of percent passing [-]
    double cell_width = 4;           ///< in diameters of the largest grain [-]
    double skeleton_width = 6;       ///< in median diameters of the coarse grains, by number [-]
    double fine = 100, coarse = 100; ///< grains of either fraction
};

/// Least number of grains that stand for `grading`, whose fines are smaller than `finer_than` [m].
double representative_count(const Grading& grading, double finer_than, const Representative& spec = {});

struct ModeledPart {
    double finest = 0, coarsest = 0;        ///< [m], to three digits
    double fines_kept = 0, coarse_kept = 0; ///< of their mass [-]
};

/// Where the fines of a grading end and where its skeleton begins; between them a gap may lie [m].
struct FractionEnds {
    double finer_than = 0, coarser_than = 0;
};

/// The part of a grading that `most` grains stand for and that leaves out least, as a share of the fines' mass and of
/// the skeleton's mass: the larger of the two counts. Nothing where less than a tenth of either would stay.
std::optional<ModeledPart>
find_modeled_part(const Grading& grading, const FractionEnds& ends, double most, const Representative& spec = {});

/// The same cut at one end only, as far as `particles` grains follow the curve within `tolerance`: without what is
/// finer, or coarser, than this size [m].
std::optional<double> followed_above(const Grading& grading, double particles, double tolerance);
std::optional<double> followed_below(const Grading& grading, double particles, double tolerance);

} // namespace suffuse::grains
