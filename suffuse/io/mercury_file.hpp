#pragma once
// Packings of MercuryDPM: its .data files, of which the last frame is read, and its .restart files.
// [MercuryDPM, Kernel/DPMBase: a frame begins with number, time and box; a row is position, velocity, radius, angles,
// spin and a number of the user's.]

#include "suffuse/io/packing_file.hpp"

#include <string>
#include <string_view>

namespace suffuse::io {

bool looks_like_mercury_data(std::string_view text);
ImportedPacking parse_mercury_data(const std::string& file, std::string_view text, double density);

bool looks_like_mercury_restart(std::string_view text);
ImportedPacking parse_mercury_restart(const std::string& file, std::string_view text, double density);

} // namespace suffuse::io
