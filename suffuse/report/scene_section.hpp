#pragma once
// The section "In 3D" of the page: the place of the view, its still pictures, and the numbers of each state.

#include "suffuse/report/numbering.hpp"
#include "suffuse/report/scene.hpp"

#include <string>

namespace suffuse::report {

/// HTML below the section's heading. @param has_script the page carries the script that draws the view @param
/// has_stills the page shows the still pictures elsewhere
std::string scene_section(const Scene& scene, bool has_script, bool has_stills, Numbering& numbering);

/// First and last state: those that have a still picture.
std::vector<std::size_t> still_states(const Scene& scene);

} // namespace suffuse::report
