#pragma once
// A packing brought from elsewhere, as a stage takes it: read, checked, and with what is to be said of it.

#include "suffuse/casefile/case.hpp"
#include "suffuse/dem/given_contacts.hpp"
#include "suffuse/grains/grains.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace suffuse::record {

struct ImportedSample {
    grains::Grains grains;                   ///< those that the soil has as fine are marked
    Mat3 h{};                                ///< columns are the cell vectors [m]
    Mat3 velocity_gradient{};                ///< of the cell, which the velocities contain [1/s]
    double overlap = 0;                      ///< largest, over the smaller radius [-]
    std::vector<std::string> warnings;       ///< each with its place
    std::vector<dem::GivenContact> contacts; ///< what its contacts remember, where the case names a file of it
};

/// @param where the stage, for messages
/// @throws IoError, CaseError as io::take_packing and mark_fines do; CaseError where neither the case nor the file
/// gives a cell.
ImportedSample
read_import(const casefile::ImportSpec& spec, const casefile::Variant& variant, const std::string& where);

struct CheckedImports {
    std::int64_t largest = 0;          ///< grains of the largest
    std::vector<std::string> warnings; ///< what there is to be said of them
};

/// Reads all packings that a case imports, each once. @throws as read_import.
CheckedImports check_imports(const casefile::Case& what);

} // namespace suffuse::record
