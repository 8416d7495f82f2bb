#pragma once
// All pictures of a sample in one collection over its stages and passes, and a script that opens it in ParaView.

#include "suffuse/casefile/case.hpp"

#include <filesystem>

namespace suffuse::run {

/// Writes grains.pvd and view.py in the folder of the sample, of the pictures that its finished stages left; nothing
/// where they left none. Time counts the pictures.
void write_picture_series(const std::filesystem::path& run, const casefile::Variant& variant);

} // namespace suffuse::run
