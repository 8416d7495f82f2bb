#pragma once
// What becomes of fines that migrate, as plain values.

#include "suffuse/base/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace suffuse::erosion {

/// A solution of the flow, and what happened until the next one.
struct MigrationRow {
    double time = 0;            ///< at its end, since the first gradient [s]
    double gradient = 0;        ///< prescribed [-]
    double sample_gradient = 0; ///< of the whole cell: the same but in a stack [-]
    double base_gradient = 0;   ///< as the base has it now; the same but in a stack [-]
    double filter_gradient = 0; ///< likewise of the filter [-]
    double permeability = 0;    ///< along the flow, among the grains that do not go with it [m2]
    double eroded_mass = 0;     ///< so far [kg]
    double moving_mass = 0;     ///< [kg]
    double lodged_mass = 0;     ///< that left its place and rests in another [kg]
    double energy = 0;          ///< spent by the flow so far, integral of rho g Q i L dt [J]
    double fed_mass = 0;        ///< that has entered with the water so far [kg]
};

/// What ended a gradient.
enum class HoldEnd {
    None,      ///< it goes on
    Rest,      ///< so few fines moved
    AllLeft,   ///< none is there that could move, and none comes
    HoldLimit, ///< `hold_at_most`
    TimeLimit, ///< `time_at_most`
    StepLimit, ///< `steps_at_most`
};

/// "", "rest", "all-left", or the key of the limit.
constexpr std::string_view name_of(HoldEnd end) {
    switch (end) {
    case HoldEnd::None:
        return "";
    case HoldEnd::Rest:
        return "rest";
    case HoldEnd::AllLeft:
        return "all-left";
    case HoldEnd::HoldLimit:
        return "hold_at_most";
    case HoldEnd::TimeLimit:
        return "time_at_most";
    case HoldEnd::StepLimit:
        return "steps_at_most";
    }
    return "";
}

/// What became of a gradient.
struct MigrationHold {
    double gradient = 0;        ///< [-]
    double sample_gradient = 0; ///< of the whole cell: the same but in a stack [-]
    double held_for = 0;        ///< true time [s]
    bool ended = false;         ///< motion did: `ended_by` is Rest or AllLeft
    HoldEnd ended_by = HoldEnd::None;
    double eroded_mass_share = 0, moving_mass_share = 0; ///< of the fines' mass, at its end [-]
    double permeability = 0;                             ///< of the last flow in it [m2]
    double porosity = 0;                                 ///< at its end, after the skeleton has moved if it may [-]
    double volumetric_strain = 0;                        ///< of the skeleton after it, compression positive [-]
    double stress_kept = 1; ///< of the mean stress, by a skeleton at constant volume without the grains that left [-]
    bool failed = false;    ///< the skeleton does not carry its stresses any more
    double entered_mass_share = 0; ///< of the base's mass: beyond the interface of a stack, eroded or not [-]
    double depth = 0; ///< beyond the interface, of 95 % of the mass of a base that is in the filter still [m]
};

/// Where the base of a stack is, in slices along the flow.
struct BaseProfile {
    double first = 0, step = 0;            ///< beginning of the first slice from the interface, and their thickness [m]
    std::vector<double> filter;            ///< solid volume of the filter, a row a slice, over that of the slice [-]
    std::vector<std::vector<double>> base; ///< likewise of the base: before, and at the end of each hold
};

/// Circles in which a plane along the flow cuts a stack, a row a grain that it meets.
struct StackCut {
    double width = 0;                  ///< of the stack in that plane, periodic [m]
    std::vector<double> along, across; ///< centers: along the flow from where the filter begins, and across it [m]
    std::vector<double> radius;        ///< of the circle [m]
    std::vector<std::uint8_t> is_base; ///< 1: a base grain, 0: one of the filter
};

/// Classes of the base by size, of equal mass, without the grains that are held: a row a class, the finest first.
struct BaseSizes {
    std::vector<double> diameter;        ///< mean by mass [m]
    std::vector<double> mass_share;      ///< of the free base [-]
    std::vector<double> entered, eroded; ///< of the class: beyond the interface, and across the exit [-]
};

/// What shows whether a filter holds.
struct FilterView {
    double filter_d15 = 0, base_d85 = 0; ///< of the grains that are there, by mass [m]; 0: no stack
    std::optional<double> base_gap;      ///< its fine end: coarser grains of such a base do not count [m]
    double passed = 0;                   ///< of the mass of base grains that count: eroded at the end [-]
    double constriction = 0;             ///< controlling, of the filter alone [m]
    double largest_eroded = 0;           ///< diameter of the largest base grain that left [m]; 0: none
    StackCut before, after;
    BaseSizes sizes; ///< at the end
};

/// Along the flow, in slices across it, counted from where the water enters the cell; a row a state: before, and at the
/// end of each hold (sample_profile.hpp).
struct SampleProfile {
    std::size_t slices = 0;                           ///< of the cell; 0: none
    std::vector<double> step;                         ///< thickness of a slice [m]
    std::vector<std::vector<double>> porosity, fines; ///< fines: solid volume over that of the slice [-]
    std::vector<std::vector<double>> permeability;    ///< along the flow [m2]
};

/// What has become of a fine grain.
enum class Whereabouts {
    Stayed, ///< within half a diameter of where it rested first
    Lodged, ///< left its place and rests in another
    Moving, ///< when the stage ended
    Eroded, ///< crossed the exit
    Fixed,  ///< carries the skeleton's forces: held
};

/// "stayed", "lodged", "moving", "eroded", "fixed".
constexpr std::string_view name_of(Whereabouts where) {
    switch (where) {
    case Whereabouts::Stayed:
        return "stayed";
    case Whereabouts::Lodged:
        return "lodged";
    case Whereabouts::Moving:
        return "moving";
    case Whereabouts::Eroded:
        return "eroded";
    case Whereabouts::Fixed:
        return "fixed";
    }
    return "";
}

/// Throats of the coarse skeleton that a grain has passed since it rested first (passed_throats.hpp).
struct PassedThroats {
    std::int32_t count = 0;    ///< without those that it came back through at once
    double narrowest = 0;      ///< diameter of the constriction, coming back or not; 0: none was passed [m]
    std::int64_t last = never; ///< twice the throat, and the side that it came from

    static constexpr std::int64_t never = -1;

    bool operator==(const PassedThroats&) const = default;
};

/// All fines of the sample, those that left too. Every column has a row a grain, in the order of the sample's table.
struct MigrationLedger {
    std::vector<std::uint32_t> id;
    std::vector<double> diameter, mass; ///< [m], [kg]
    std::vector<Vec3> start, end;       ///< where it rested before the flow, and where it is, or was last [m]
    std::vector<double> entered;        ///< time at which it entered with the water; negative: was there [s]
    std::vector<double> to_exit;        ///< along the flow from its start [m]
    std::vector<double> departed;       ///< time at which it was half a diameter from its start; negative: never [s]
    std::vector<double> departed_at;    ///< the gradient then [-]
    std::vector<double> left;           ///< time at which it crossed the exit; negative: never [s]
    std::vector<PassedThroats> passed;  ///< of the coarse skeleton
    std::vector<Whereabouts> where;
    std::vector<std::uint8_t> goes; ///< 1: with the water, so that it does not resist it
    std::vector<Vec3> before;       ///< where it was when motion was last looked at [m]

    [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// States that a stage keeps over the longest that it may take, and at the ends of its holds: as many as a
/// reader looks at, and few enough for a disk.
inline constexpr int frames_kept = 16;

/// A state that was kept for those who look.
struct MigrationFrame {
    double time = 0;         ///< since the first gradient [s]
    double gradient = 0;     ///< prescribed then; 0: at rest before the flow [-]
    double weight_scale = 1; ///< by which the forces of its fines are too large: WeightScale::factor
};

/// What became of all fines: a row a grain.
struct MigrationFates {
    std::vector<std::uint32_t> id;
    std::vector<Whereabouts> where;
};

/// The grain that passed most throats of those that left their place.
struct GrainStory {
    std::uint32_t id = 0;
    double diameter = 0;                ///< [m]
    double departed = 0, gradient = 0;  ///< when it left its place [s], and under which gradient
    double way = 0;                     ///< from its start to where it is, or was last [m]
    std::int32_t throats = 0;           ///< that it passed
    double narrowest = 0;               ///< diameter of the narrowest [m]
    double left = -1;                   ///< when it crossed the exit; negative: never [s]
    bool moves = false;                 ///< when the stage ended
    std::vector<std::uint32_t> holders; ///< ids of the grains that it touches
};

struct MigrationResult {
    std::vector<MigrationRow> rows;
    std::vector<MigrationHold> holds;
    std::vector<MigrationFrame> frames;
    MigrationFates fates;
    GrainStory story;                ///< without throats: no grain has passed one
    double fines_mass = 0;           ///< of the sample before, but for the screen of a stack: what shares are of [kg]
    double resting_permeability = 0; ///< along the flow, before any grain moves [m2]
    BaseProfile profile;             ///< of a stack
    FilterView filter;               ///< likewise
    SampleProfile sample;            ///< of others
};

/// Mass that crossed the exit [kg].
double eroded_mass(const MigrationLedger& ledger);

/// The same, without the grains that the water had brought [kg].
double own_eroded_mass(const MigrationLedger& ledger);

/// Of the fines whose whereabouts are these [kg].
double mass_of(const MigrationLedger& ledger, Whereabouts where);

/// Mass of the fines before over that with what the water brought: by which shares of the one become those of the
/// other.
double share_of_own(const MigrationResult& result);

} // namespace suffuse::erosion
