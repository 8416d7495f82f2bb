#pragma once
// The sample grain by grain, for the report's view in 3D and for the still picture that stands in for it: the same
// grains in several states, of which later ones may have lost some. Plain values, SI; they reach the page as base64.

#include "suffuse/base/vec3.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::report {

/// A touching contact, by rows of the scene's grains; the image of `j` that `i` touches lies in the neighboring period
/// (a, b, c), each -1, 0 or 1, of j's place in the cell.
struct SceneContact {
    std::uint32_t i = 0, j = 0;
    std::array<int, 3> period{};
    double normal_force = 0; ///< compression positive [N]
};

/// Numbers of one state for the table below the view.
struct SceneCount {
    std::int64_t grains = 0, fines = 0, rattlers = 0; ///< rattlers: fewer than two contacts
    std::int64_t contacts = 0, strong = 0;            ///< strong: normal force above the mean
    double mean_force = 0, largest_force = 0;         ///< normal force over the contacts [N]
};

/// One state. Columns have a row for each grain of the scene; rows of grains that are gone mean nothing.
struct SceneState {
    std::string label;                      ///< "before erosion", "after pass 1"
    int passes = 0;                         ///< erosion passes that lie behind it; in a migration the state's index
    std::optional<double> time, gradient;   ///< since the first gradient [s], and hydraulic then; of migrations only
    Mat3 h = identity();                    ///< columns are the cell vectors [m]
    std::vector<Vec3> position;             ///< within the cell [m]
    std::vector<std::array<int, 3>> period; ///< of migrations only: periods that the grain is away from there, so that
                                            ///< its way is known across the faces of the cell
    std::vector<int> coordination;          ///< contacts of the grain
    std::vector<double> speed, fluid_force; ///< in the probe of the next pass; not a number where it saw no such grain,
                                            ///< empty without a probe [m/s], [N]
    std::vector<double> mobile_gradient;    ///< that moves it against its weight; not a number where none does, empty
                                            ///< if not requested [-]
    std::vector<SceneContact> contacts;     ///< of a migration only those of fines that are free to move
    std::optional<SceneCount> whole;        ///< with the contacts that were left out; nothing where none was
};

struct Scene {
    std::vector<std::uint32_t> id;  ///< ascending
    std::vector<double> radius;     ///< [m]
    std::vector<std::uint8_t> fine; ///< 1: of the fine fraction
    std::vector<int> left_in;       ///< pass in which it left, or state from which it is gone; 0: it stays
    std::vector<int> entered_in;    ///< state from which it is there; 0: from the first; empty: all are
    std::vector<std::uint8_t> fate; ///< how its migration ended, by rows of `fates`; empty outside migrations
    std::vector<std::string> fates; ///< in plain words
    std::vector<SceneState> states; ///< in order of time; empty: no view
    Vec3 flow_direction;            ///< unit vector; zero without water
    double gradient = 0;            ///< hydraulic gradient of the probes [-]
    std::string remark;             ///< what the view leaves out, for the reader; may be empty
};

/// Whether grain `g` is still there in the state.
inline bool is_present(const Scene& scene, const SceneState& state, std::size_t g) {
    const bool has_come = scene.entered_in.empty() || scene.entered_in[g] <= state.passes;
    return has_come && (scene.left_in[g] == 0 || scene.left_in[g] > state.passes);
}

SceneCount count_scene(const Scene& scene, const SceneState& state);

/// Leaves the contacts out that bear no more than the mean normal force; what count_scene counts is still of all.
void leave_out_weak_contacts(const Scene& scene, SceneState& state);

/// For the page's script. Numeric columns are base64 of little-endian arrays, named with their type ("u16", "f32",
/// ...): positions as fractions of the cell vectors in 1/65535; forces, speeds, radii single precision.
nlohmann::json scene_json(const Scene& scene);

} // namespace suffuse::report
