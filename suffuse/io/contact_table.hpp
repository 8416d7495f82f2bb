#pragma once
// Contacts of a packing file, which that file has no place for: what they remember, for other programs and from them.
//
// Our own table is CSV: first, second (rows of the packing, from 0), shear force and moment on the first grain [N, N
// m]. LAMMPS has a dump of local values, `pair_style granular`, with these columns in this order, ids from 1: patom1
// patom2 | shear force on the first | rolling force on it | vector from the second to the first grain. Its rolling
// force acts at the reduced radius R of the pair: the moment is R n x force [LAMMPS manual, pair granular].

#include "suffuse/dem/given_contacts.hpp"

#include <filesystem>
#include <vector>

namespace suffuse::io {

/// The touching contacts of `world`, whose grains are counted as its rows are. @throws IoError.
void export_contacts(const std::filesystem::path& path, const dem::World& world);

/// Reads either table, plain or gzipped; of a dump its last frame.
/// @param grains of the packing, in the order of its file
/// @throws IoError where the file cannot be read, CaseError with file and line where its content makes no sense.
std::vector<dem::GivenContact> read_contacts(const std::filesystem::path& path, const grains::Grains& grains);

} // namespace suffuse::io
