#pragma once
// The figures of a run as files for a manuscript. SVG by Vega in Node, PNG and PDF from it by rsvg-convert.

#include "suffuse/figures/figure.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::job {

/// How figures are drawn as files.
struct DrawStyle {
    std::string format = "svg";  ///< svg, png, pdf
    std::optional<double> width; ///< [m]; nothing: as wide as each figure is by itself
    std::string font;            ///< empty: that of the report
};

/// Draws figures of the run's folder, those wanted (by number or name) or all, into `folder`.
/// @param page the built page of the report, next to the drawing program
/// @return the files
/// @throws UsageError for a figure that the run has not, IoError saying what to install or what cannot be written
std::vector<std::filesystem::path> draw_figures(
    const std::filesystem::path& run, const std::vector<std::string>& wanted, const DrawStyle& style,
    const std::filesystem::path& folder, const std::filesystem::path& page
);

/// Gives each chart its drawing for a page that runs no script, from the specifications in the run's folder. Where
/// Node or the built page is not there, or cannot draw one, that chart is left to the page's script; where the
/// environment has SUFFUSE_STILLS=no, all are.
void draw_in_page(
    std::vector<figures::Figure>& figures, const std::filesystem::path& run, const std::filesystem::path& page
);

/// Draws one figure as `file` says by its ending, .svg, .png or .pdf. @throws as above
void draw_figure(
    const std::filesystem::path& run, const std::string& which, const std::filesystem::path& file,
    const std::filesystem::path& page
);

} // namespace suffuse::job
