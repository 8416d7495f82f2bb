#pragma once
// The section "In 3D" of the page: the place of the view, its still pictures, and the numbers of each state.

#include "suffuse/report/scene.hpp"

#include <string>

namespace suffuse::report {

/// HTML below the section's heading; `has_script`: the page carries the script that draws the view.
std::string scene_section(const Scene& scene, bool has_script);

/// First and last state: those that have a still picture.
std::vector<std::size_t> still_states(const Scene& scene);

} // namespace suffuse::report
