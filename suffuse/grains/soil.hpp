#pragma once
// What a case says of a soil: its grading, and which grains count as fine.

#include <optional>
#include <string>
#include <vector>

namespace suffuse::grains {

/// A grading curve: percent passing by mass against diameter, both increasing; linear in log d between its points.
struct Grading {
    std::vector<double> diameter; ///< [m]
    std::vector<double> passing;  ///< mass fraction finer, 0 to 1 [-]
    std::string origin;           ///< file it was read from, for messages
};

/// What two fractions stand for: grains/surrogate.hpp.
struct Surrogate {
    double finer_than = 0;    ///< where the soil's curve is split [m]
    double ratio_of_soil = 0; ///< D50 of its coarse part / d50 of its fines [-]
    double size_ratio = 0;    ///< of the two fractions [-]
    double coarse_width = 0;  ///< largest size over smallest of the coarse fraction [-]
    double fines_width = 0;   ///< likewise of the fines [-]
};

/// Either one grading with a size below which grains are fine, or two gradings mixed at a fines content.
struct Soil {
    std::optional<Grading> whole;
    std::optional<Grading> measured;  ///< the curve, with open ends or not, of which `whole` or a surrogate is modeled
    std::optional<double> finer_than; ///< fines are smaller than this diameter [m]
    bool kenney_lau = false;          ///< fines by Kenney and Lau's split where it exists
    bool report_kenney_lau = false;   ///< report that split too, without using it
    std::optional<Surrogate> surrogate; ///< `coarse` and `fines` stand for the soil of `measured`
    std::optional<Grading> coarse, fines;
    double fines_content = 0;        ///< by mass, of the mixture of `coarse` and `fines` [-]
    double grading_tolerance = 0.02; ///< largest difference of percent passing between sample and grading [-]
};

} // namespace suffuse::grains
