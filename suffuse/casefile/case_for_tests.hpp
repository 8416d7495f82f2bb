#pragma once
// Cases for this room's tests: one that uses every key, and ways to look at what is wrong with others.

#include "suffuse/casefile/load_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace suffuse::casefile::testing {

/// A folder of this process with the data files that cases name; goes with the process.
struct DataFolder {
    std::string path = ::testing::TempDir() + "suffuse_casefile_" + std::to_string(::getpid());

    DataFolder() {
        std::filesystem::create_directories(path + "/data");
        std::ofstream(path + "/data/sand.csv") << "d [mm],passing [%]\n0.1,0\n0.2,50\n0.4,100\n";
        std::ofstream(path + "/data/silt.csv") << "d [mm],passing [%]\n0.05,0\n0.06,100\n";
        std::ofstream(path + "/data/points.csv") << "x,y\n";
        std::ofstream(path + "/packing.csv") << "x,y,z,r\n0,0,0,1e-3\n";
        std::ofstream(path + "/contacts.csv") << "first,second,shear_x,shear_y,shear_z,moment_x,moment_y,moment_z\n";
    }

    DataFolder(const DataFolder&) = delete;
    DataFolder& operator=(const DataFolder&) = delete;

    ~DataFolder() { std::filesystem::remove_all(path); }
};

inline std::string data_folder() {
    static const DataFolder folder;
    return folder.path;
}

/// What loading finds, errors and warnings; empty where all is well.
inline std::vector<Diagnostic> problems_of(const std::string& text, const LoadOptions& options = {}) {
    try {
        return load_case_text(text, "case.toml", data_folder(), options).warnings;
    } catch (const CaseProblems& problems) {
        return problems.problems;
    }
}

inline Case load(const std::string& text, const LoadOptions& options = {}) {
    return load_case_text(text, "case.toml", data_folder(), options).value;
}

/// The problem with this code, or one that says that there is none, with all that were found.
inline Diagnostic find_problem(const std::vector<Diagnostic>& list, const std::string& code) {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Diagnostic& d) { return d.code == code; });
    Diagnostic none;
    none.message = "no " + code + " among\n" + render(list);
    return found == list.end() ? none : *found;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

/// The head of a small case that is good, for a test to put something wrong below or into.
inline const std::string good_case = R"(schema = 1
[soil.sand]
psd = "data/sand.csv"
fines = { finer_than = "0.15 mm" }
[study.one]
soil = "sand"
particles = 20000
[[study.one.stage]]
name = "cloud"
do = "pack"
[[study.one.stage]]
name = "initial"
do = "compact"
pressure = "100 kPa"
)";

/// One more stage for its study.
inline const std::string erode_stage = "[[study.one.stage]]\nname = \"x\"\ndo = \"erode\"\n";

/// Stages for its study that stand next to weight alone.
inline const std::string keys_of_weight = R"([[study.one.stage]]
name = "probe"
do = "detach"
asked_gradient = 0.2
[[study.one.stage]]
name = "erosion"
do = "erode"
[[study.one.stage]]
name = "migration"
do = "migrate"
gradients = [0.2, 0.5]
direction = "z"
exit = "2 mm"
skeleton = "held"
hold_at_most = "500 ms"
still = "1 %"
still_for = "20 ms"
softness = 1e-4
friction = "10 deg"
with_water = 0.3
solve_after = 0.1
feed = "0.5 kg/m^3"
time_at_most = "1 s"
steps_at_most = 1_000_000
[gravity]
down = "-z"
)";

/// A case that uses every key which can stand next to the others.
inline const std::string full_case = R"(schema = 1
title = "All \"keys\"\n and a tab\t"
paper = "none"
seed = 42
[grain]
density = "2.7 g/cm^3"
[contact]
law = "linear-rolling"
modulus = "1 GPa"
shear_ratio = 0.3
friction = "33.3 deg"
rolling_stiffness = 1
rolling_friction = -1
twisting_stiffness = 0.1
twisting_friction = 0.2
damping = "25 %"
adhesion = { normal = "1 kPa", shear = "2 kPa" }
[balance]
unbalanced_force = 1e-4
stress_error = "0.1 %"
patience = 100
[fluid]
density = "998 kg/m3"
viscosity = "1.002e-3 Pa*s"
bulk_modulus = "2.2 GPa"
conductance = "yade"
[soil.whole]
psd = "data/sand.csv"
fines = { finer_than = "150 um" }
fines_auto = "kenney-lau"
grading_tolerance = "1 %"
[soil.two]
coarse = { psd = "data/sand.csv" }
fines = { psd = "data/silt.csv" }
fines_content = "20 %"
fines_auto = "none"
[soil.part]
psd = { d = ["50 um", "0.2 mm", "1 mm"], passing = ["10 %", "60 %", "90 %"] }
sizes = ["0.2 mm", "1 mm"]
[soil.stand-in]
psd = { d = ["50 um", "0.2 mm", "1 mm"], passing = ["10 %", "60 %", "90 %"] }
surrogate = { finer_than = "0.2 mm", size_ratio = 3 }
[soil.split]
psd = "data/sand.csv"
fines = "kenney-lau"
[study.main]
soil = "two"
particles = 200_000
sweep = { fines_content = ["10 %", 0.2], "stage.initial.pressure" = ["50 kPa", "100 kPa"] }
refine = { key = "fines_content", around = "minimum", of = "void_ratio", at = ["initial"], add = 2 }
replicates = 2
[[study.main.stage]]
name = "cloud"
do = "pack"
porosity = 0.7
[[study.main.stage]]
name = "initial"
do = "compact"
pressure = "100 kPa"
protocol = "swift"
start_porosity = 0.5
prepare = { friction = "5 deg", adhesion = { normal = "1 MPa", shear = "2 MPa" } }
void_ratio = 0.7
void_ratio_tolerance = 0.001
max_rate = "100 1/s"
time_step = "1e-8 s"
measure = ["void-ratios", "permeability"]
[[study.main.stage]]
name = "probe"
do = "detach"
gradients = [0, "5 %"]
direction = [1, 2, -2]
hold = "none"
ramp = 500
watch = 2_000
probe_unbalanced_force = 1e-7
relax_limit = 1000
solver = "resolved"
resolve = 8
resolve_tolerance = 1e-5
detached = { by = "displacement", over = "0.1 d", noise_quantile = 0.99 }
restore = true
only = { fines_content = [0.1] }
[[study.main.stage]]
name = "erosion"
from = "initial"
do = "erode"
passes = 3
until_nothing_leaves = true
until_eroded = { share = "40 %", of = "solids" }
gradient = 0.1
direction = "-y"
detached = { by = "velocity", rule = "above", over = "1e-5 m/s" }
passes_constriction = { size = "d50", of = "coarse", merge = "overlap", distance = "3 mm" }
forced = { max_contacts = 2 }
then = "settle"
record = { every = 10 }
[[study.main.stage]]
name = "shear"
do = "triaxial"
path = "undrained"
axis = "x"
strain = "20 %"
deviator_stress = "50 kPa"
inertial_number = "strict"
rows = 100
[[study.main.stage]]
name = "widened"
from = "initial"
do = "triaxial"
path = "proportional"
strain_ratio = -0.5
stress_ratio = 0.5
[[study.main.stage]]
name = "stability"
do = "stress-probe"
axis = "y"
directions = 36
increment = "2 %"
ramp = 2000
unbalanced_force = 1e-6
max_strain = "2 %"
max_steps = 10_000
[[study.main.stage]]
name = "stiff"
do = "stiffness"
increment = 2e-6
unbalanced_force = 1e-7
max_steps = 10_000
[[study.main.stage]]
name = "emptied"
from = "initial"
do = "remove"
grains = "inactive-fines"
share = "50 %"
order = "least-stressed"
passes = 5
max_strain = "10 %"
[[study.main.stage]]
name = "extended"
from = "initial"
do = "triaxial"
direction = "extension"
b = 0.4
strain = "10 %"
[[study.main.stage]]
name = "one-dimensional"
from = "initial"
do = "oedometer"
axis = "y"
stresses = ["400 kPa", "50 kPa"]
strain = "10 %"
inertia = "own"
[[study.main.stage]]
name = "all-around"
from = "initial"
do = "isotropic"
stresses = ["200 kPa", "100 kPa", "400 kPa"]
rows = 50
[[study.main.stage]]
name = "plane"
from = "initial"
do = "plane-strain"
axis = "x"
direction = "extension"
strain = "5 %"
[[study.main.stage]]
name = "sheared"
from = "initial"
do = "shear"
hold = "stress"
axes = "xy"
strain = "30 %"
time_step = "1e-8 s"
[[study.main.stage]]
name = "shaken"
from = "initial"
do = "cyclic"
drainage = "drained"
axis = "y"
csr = 0.15
cycles = 5
until = { pore_pressure_ratio = 0.9, double_amplitude = "2 %" }
[[study.main.stage]]
name = "strained"
from = "initial"
do = "cyclic"
strain_amplitude = "0.1 %"
[study.other]
soil = "whole"
[[study.other.stage]]
name = "start"
do = "import"
packing = "packing.csv"
contacts = "contacts.csv"
cell = [["1 mm", "0.1 mm", "0 mm"], ["0 mm", "1 mm", "0 mm"], ["0 mm", "0 mm", "1 mm"]]
unit = "1 mm"
max_overlap = "5 %"
radius = "0.5 mm"
velocity_gradient = [["1 1/s", "0 1/s", "0 1/s"], ["0 1/s", "1 1/s", "0 1/s"], ["0 1/s", "0 1/s", "1 1/s"]]
[[study.other.stage]]
name = "settled"
do = "settle"
stress = ["100 kPa", "-", "50 kPa"]
servo = { kind = "inertial", mass = "0.0063 kg/m", damping = 0.3, max_rate = "60 1/s", response = 200 }
max_steps = 1000
[[study.other.stage]]
name = "go"
do = "advance"
steps = 10
time_step = "computed"
strain_rate = ["1 1/s", "-", "2 1/s"]
stress = ["-", "10 kPa", "-"]
[[study.other.stage]]
name = "turn"
do = "advance"
steps = 10
velocity_gradient = [["-70 1/s", "25 1/s", "0 1/s"], ["0 1/s", "1 1/s", "0 1/s"], ["0 1/s", "0 1/s", "1 1/s"]]
[[study.other.stage]]
name = "seep"
do = "flow"
gradient = 0.05
direction = "x"
tensor = true
resolve = 12
[study.sized]
soil = "two"
sample_size = { coarse_grains = 2_000, cell_width = 12, at_least = 3_000, at_most = 90_000, least_coarse = 70 }
[[study.sized.stage]]
name = "cloud"
do = "pack"
[[study.sized.stage]]
name = "initial"
do = "compact"
pressure = "100 kPa"
shear_stresses = "released"
intergranular_void_ratio = 0.8
if_unreachable = "nearest"
prepare = { skeleton_first = true }
[[study.sized.stage]]
name = "alike"
from = "cloud"
do = "compact"
pressure = "100 kPa"
intergranular_void_ratio = 0.8
prepared_as = { fines_content = "20 %" }
[study.layered]
[[study.layered.stage]]
name = "cloud"
do = "pack"
porosity = 0.55
layers = [{ soil = "base", thickness = "0.35 mm" }, { soil = "filter", thickness = "2 mm" }]
axis = "x"
width = "2 mm"
[soil.base]
psd = { d = ["90 um", "110 um"], passing = ["0 %", "100 %"] }
[soil.filter]
psd = { d = ["0.5 mm", "0.6 mm"], passing = ["0 %", "100 %"] }
grading_tolerance = "5 %"
[output]
formats = ["csv", "vtp"]
snapshots = { every = "1 %" }
checkpoint = "5 min"
histories = { every = 50 }
[report]
figures = ["own", "figure-9"]
psd_axis = "reversed"
dilation = "up"
overlay = { figure-2 = "data/points.csv" }
)";

} // namespace suffuse::casefile::testing
