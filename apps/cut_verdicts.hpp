#pragma once
// Internal stability of a grading as given next to that of the part which a sample models: the criteria read the ends
// of a curve, so a cut can turn their verdicts.

#include "suffuse/grains/soil.hpp"

#include <string>
#include <vector>

namespace suffuse::apps {

struct CutVerdicts {
    struct Turned {
        std::string id, name;       ///< of the criterion
        std::string given, modeled; ///< "unstable", "stable"
    };

    std::string given, modeled; ///< "6 of 7 criteria say unstable (...), 1 stable (...)"
    std::vector<Turned> turned; ///< verified criteria that say otherwise of the part
};

/// Both with the same fines, so that only the cut makes a difference.
/// @param measured   the curve as given, whose ends may be open
/// @param finer_than of both [m]
CutVerdicts judge_cut(const grains::Grading& measured, const grains::Grading& modeled, double finer_than);

/// "unstable -> stable: Kezdi 1979, ...; ..."; empty where none was turned.
std::string turned_text(const CutVerdicts& verdicts);

} // namespace suffuse::apps
