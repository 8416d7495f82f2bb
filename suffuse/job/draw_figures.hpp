#pragma once
// The figures of a run as files for a manuscript. SVG by Vega in Node, PNG and PDF from it by rsvg-convert.

#include <filesystem>
#include <string>
#include <vector>

namespace suffuse::job {

/// Draws figures of the run's folder, those wanted (by number or name) or all, as svg, png or pdf into `folder`.
/// @param page the built page of the report, beside which the drawing program lies
/// @return the files
/// @throws UsageError for a figure that the run has not, IoError saying what to install or what cannot be written
std::vector<std::filesystem::path> draw_figures(
    const std::filesystem::path& run, const std::vector<std::string>& wanted, const std::string& format,
    const std::filesystem::path& folder, const std::filesystem::path& page
);

/// Draws one figure as `file` says by its ending, .svg, .png or .pdf. @throws as above
void draw_figure(
    const std::filesystem::path& run, const std::string& which, const std::filesystem::path& file,
    const std::filesystem::path& page
);

} // namespace suffuse::job
