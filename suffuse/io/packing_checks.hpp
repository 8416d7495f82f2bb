#pragma once
// A packing from elsewhere as all callers take it (a case, `suffuse import`, a benchmark, Python):
// read, put into the requested cell, and checked: sizes, positions, overlaps, lengths that cannot be meant.

#include "suffuse/io/cut_box.hpp"
#include "suffuse/io/packing_file.hpp"

namespace suffuse::io {

constexpr double usual_overlap = 0.1; ///< beyond, of the smaller radius, it is another cell's packing

/// What a packing must meet.
struct PackingRequest {
    std::filesystem::path file;
    double density = 2600;                      ///< of the grains [kg/m3]
    double unit = 1;                            ///< what a length of 1 in the file stands for [m]
    std::optional<double> radius = {};          ///< of all grains, for a file that has none [m]
    std::optional<Mat3> cell = {};              ///< in place of the file's own; columns are the cell vectors [m]
    std::optional<Box> box = {};                ///< to be cut out of a bed, in the file's coordinates; the cell then
    std::optional<Mat3> velocity_gradient = {}; ///< that the velocities of the file contain; found in them unless given
    double max_overlap = usual_overlap;         ///< largest overlap that is accepted / radius of the smaller grain [-]
    bool only_looks = false;                    ///< a larger overlap is then a warning
    std::string where;                          ///< the caller, in front of warnings; the file unless given
};

struct TakenPacking {
    grains::Grains grains;             ///< in the order of the file; `id` counts from 0
    std::optional<Mat3> h;             ///< columns are the cell vectors [m]; none where nobody gives a cell
    Mat3 velocity_gradient{};          ///< of the cell, which the velocities contain [1/s]
    std::optional<CutGrains> left_out; ///< where a box was cut out
    std::string no_cell;               ///< why there is none, to be said by who needs one
    double overlap = 0;                ///< largest, over the smaller radius [-]
    double mean_overlap = 0;           ///< of the pairs that overlap, over the smaller radius [-]
    std::size_t contacts = 0;          ///< pairs that overlap, in the cell
    std::vector<std::string> warnings; ///< each with its place
};

/// @throws as read_packing and check_overlaps.
TakenPacking take_packing(const PackingRequest& request);

/// Largest overlap of two grains over the smaller radius [-]. Throws CaseError, naming the worst pair, where it exceeds
/// `share`, the grains that lie in one place, and the grain whose position lies too far from the cell; `origin` is the
/// file that the grains come from.
double check_overlaps(
    const grains::Grains& grains, const cell::Cell& cell, double share, const std::string& origin = "packing"
);

} // namespace suffuse::io
