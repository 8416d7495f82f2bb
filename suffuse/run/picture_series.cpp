#include "suffuse/run/picture_series.hpp"

#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/vtk.hpp"
#include "suffuse/record/folder.hpp"

#include <fmt/format.h>

namespace suffuse::run {
namespace {

// Comments within say how it is started. ParaView may run it without telling it where it lies.
constexpr const char* view_script =
    R"(# The grains of this sample in ParaView, over its stages and the passes of its erosions.
#   paraview --script=view.py     in this folder, or File > Load State
#   pvbatch view.py grains.png    draws the last picture
# Fines are red and coarse grains sand; other columns to color by: leaves_in_pass, mean_stress, fluid_force, ...
import os
import sys

from paraview.simple import *

folder = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
grains = PVDReader(registrationName="grains.pvd", FileName=os.path.join(folder, "grains.pvd"))
spheres = Glyph(
    registrationName="spheres", Input=grains, GlyphType="Sphere", GlyphMode="All Points",
    ScaleArray=["POINTS", "radius"], ScaleFactor=2.0, OrientationArray=["POINTS", "No orientation array"],
)
view = GetActiveViewOrCreate("RenderView")
display = Show(spheres, view)
ColorBy(display, ("POINTS", "fine"))
colors = GetColorTransferFunction("fine")
colors.RGBPoints = [0.0, 0.81, 0.64, 0.34, 1.0, 0.78, 0.20, 0.17]
colors.ColorSpace = "RGB"
Hide(grains, view)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()
view.ResetCamera()
Render()
if len(sys.argv) > 1 and sys.argv[-1].endswith(".png"):
    SaveScreenshot(sys.argv[-1], view, ImageResolution=[1200, 1000])
)";

} // namespace

void write_picture_series(const std::filesystem::path& run, const casefile::Variant& variant) {
    std::vector<io::VtkFrame> frames;
    const auto add = [&](const std::filesystem::path& folder, const std::string& file) {
        const bool is_there = std::filesystem::exists(folder / file);
        if (is_there) {
            frames.push_back({static_cast<double>(frames.size()), folder.filename().string() + "/" + file});
        }
        return is_there;
    };
    for (const casefile::Stage& stage : variant.stages) {
        const std::filesystem::path folder = record::stage_folder(run, variant, stage);
        if (!std::filesystem::exists(folder / "stage.json")) {
            continue;
        }
        for (int pass = 0; add(folder, fmt::format("pass-{}.vtp", pass)); ++pass) {
        }
        add(folder, "grains.vtp");
    }
    if (!frames.empty()) {
        const std::filesystem::path place = run / "studies" / variant.folder;
        io::write_pvd(place / "grains.pvd", frames);
        io::write_file(place / "view.py", view_script);
    }
}

} // namespace suffuse::run
