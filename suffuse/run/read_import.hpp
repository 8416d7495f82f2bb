#pragma once
// A packing brought from elsewhere, as a stage takes it: read, checked, and with what is to be said of it.

#include "suffuse/casefile/case.hpp"
#include "suffuse/io/packing_file.hpp"

#include <string>
#include <vector>

namespace suffuse::run {

struct ImportedSample {
    grains::Grains grains;
    Mat3 h{};                          ///< columns are the cell vectors [m]
    double overlap = 0;                ///< largest, over the smaller radius [-]
    std::vector<std::string> warnings; ///< each names `where`
};

/// @param density of the grains [kg/m3]; @param where the stage, for messages
/// @throws IoError, CaseError as io::read_packing and io::check_overlaps do; CaseError where neither the case nor the
/// file gives a cell.
ImportedSample read_import(const casefile::ImportSpec& spec, double density, const std::string& where);

/// Reads all packings that a case imports, each once. @return what there is to be said of them. @throws as read_import.
std::vector<std::string> check_imports(const casefile::Case& what);

} // namespace suffuse::run
