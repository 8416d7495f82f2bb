#pragma once
// The words that a case may use where there is a choice. The first word of a value is the one that is written back.

#include "suffuse/base/error.hpp"
#include "suffuse/casefile/case.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/contact/springs.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::casefile::names {

template <class Value>
struct Word {
    Value value;
    std::string_view word;
};

/// How slowly a triaxial test loads: inertial numbers [-].
inline constexpr std::array inertial_number = {Word<double>{1e-4, "strict"}, Word<double>{1e-3, "loose"}};

enum class Then { Settle };
enum class Of { Coarse };

inline constexpr auto law = std::apply(
    [](const auto&... spring) {
        return std::array{Word<grains::ContactLaw>{spring.law, spring.words.name}...};
    },
    contact::springs
);
inline constexpr std::array then = {Word<Then>{Then::Settle, "settle"}};
inline constexpr std::array constrictions_of = {Word<Of>{Of::Coarse, "coarse"}};
inline constexpr std::array skeleton = {
    Word<erosion::Skeleton>{erosion::Skeleton::Held, "held"},
    Word<erosion::Skeleton>{erosion::Skeleton::Moves, "moves"}};
inline constexpr std::array hold = {Word<bool>{true, "coarse"}, Word<bool>{false, "none"}};
inline constexpr std::array axis = {Word<int>{0, "x"}, Word<int>{1, "y"}, Word<int>{2, "z"}};

inline constexpr std::array mode = {
    Word<dem::Mode>{dem::Mode::Reference, "reference"}, Word<dem::Mode>{dem::Mode::Fast, "fast"}};

inline constexpr std::array servo_kind = {
    Word<cell::ServoKind>{cell::ServoKind::Secant, "secant"},
    Word<cell::ServoKind>{cell::ServoKind::Inertial, "inertial"}};

inline constexpr std::array shear_stresses = {Word<bool>{false, "kept"}, Word<bool>{true, "released"}};

inline constexpr std::array protocol = {
    Word<packing::Protocol>{packing::Protocol::Faithful, "faithful"},
    Word<packing::Protocol>{packing::Protocol::Swift, "swift"},
    Word<packing::Protocol>{packing::Protocol::Slow, "slow"}, Word<packing::Protocol>{packing::Protocol::Wide, "wide"}};

inline constexpr std::array triaxial_path = {
    Word<triaxial::Path>{triaxial::Path::Drained, "drained"},
    Word<triaxial::Path>{triaxial::Path::ConstantMean, "constant-mean"},
    Word<triaxial::Path>{triaxial::Path::ConstantDeviator, "constant-deviator"},
    Word<triaxial::Path>{triaxial::Path::Undrained, "undrained"},
    Word<triaxial::Path>{triaxial::Path::Proportional, "proportional"}};

inline constexpr std::array direction = {
    Word<triaxial::Direction>{triaxial::Direction::Compression, "compression"},
    Word<triaxial::Direction>{triaxial::Direction::Extension, "extension"}};

inline constexpr std::array shear_hold = {
    Word<triaxial::Path>{triaxial::Path::ShearAtVolume, "volume"},
    Word<triaxial::Path>{triaxial::Path::ShearAtStress, "stress"}};

inline constexpr std::array drainage = {
    Word<triaxial::Path>{triaxial::Path::Undrained, "undrained"},
    Word<triaxial::Path>{triaxial::Path::Drained, "drained"}};

/// The normal of the plane, then where it slides to.
inline constexpr std::array shear_axes = {
    Word<triaxial::ShearAxes>{{2, 0}, "zx"}, Word<triaxial::ShearAxes>{{2, 1}, "zy"},
    Word<triaxial::ShearAxes>{{0, 1}, "xy"}, Word<triaxial::ShearAxes>{{0, 2}, "xz"},
    Word<triaxial::ShearAxes>{{1, 0}, "yx"}, Word<triaxial::ShearAxes>{{1, 2}, "yz"}};

inline constexpr std::array if_unreachable = {
    Word<packing::IfUnreachable>{packing::IfUnreachable::Error, "error"},
    Word<packing::IfUnreachable>{packing::IfUnreachable::Nearest, "nearest"}};

inline constexpr std::array grain_inertia = {
    Word<triaxial::GrainInertia>{triaxial::GrainInertia::Lent, "lent"},
    Word<triaxial::GrainInertia>{triaxial::GrainInertia::Own, "own"}};

inline constexpr std::array conductance = {
    Word<flow::Conductance>{flow::Conductance::Bounded, "bounded"},
    Word<flow::Conductance>{flow::Conductance::Yade, "yade"}};

inline constexpr std::array solver = {
    Word<flow::Solver>{flow::Solver::Network, "network"}, Word<flow::Solver>{flow::Solver::Resolved, "resolved"},
    Word<flow::Solver>{flow::Solver::Auto, "auto"}};

inline constexpr std::array detach_by = {
    Word<erosion::DetachBy>{erosion::DetachBy::Velocity, "velocity"},
    Word<erosion::DetachBy>{erosion::DetachBy::Displacement, "displacement"}};

inline constexpr std::array velocity_rule = {
    Word<erosion::VelocityRule>{erosion::VelocityRule::StillAccelerating, "still-accelerating"},
    Word<erosion::VelocityRule>{erosion::VelocityRule::Rising, "rising"},
    Word<erosion::VelocityRule>{erosion::VelocityRule::Above, "above"}};

inline constexpr std::array constriction_size = {
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::Mean, "mean"},
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::Median, "median"},
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::Median, "d50"},
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::D35, "d35"},
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::WidestPath, "widest-path"},
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::FlowPath, "flow-path"},
    Word<erosion::ConstrictionSize>{erosion::ConstrictionSize::None, "none"}};

inline constexpr std::array void_merge = {
    Word<pores::VoidMerge>{pores::VoidMerge::None, name_of(pores::VoidMerge::None)},
    Word<pores::VoidMerge>{pores::VoidMerge::Center, name_of(pores::VoidMerge::Center)},
    Word<pores::VoidMerge>{pores::VoidMerge::Overlap, name_of(pores::VoidMerge::Overlap)}};

inline constexpr std::array removed_fines = {
    Word<erosion::RemovedFines>{erosion::RemovedFines::All, "fines"},
    Word<erosion::RemovedFines>{erosion::RemovedFines::Inactive, "inactive-fines"},
    Word<erosion::RemovedFines>{erosion::RemovedFines::Active, "active-fines"}};

inline constexpr std::array eroded_of = {
    Word<erosion::ErodedTarget::Of>{erosion::ErodedTarget::Of::Fines, name_of(erosion::ErodedTarget::Of::Fines)},
    Word<erosion::ErodedTarget::Of>{erosion::ErodedTarget::Of::Solids, name_of(erosion::ErodedTarget::Of::Solids)}};

inline constexpr std::array removal_order = {
    Word<erosion::RemovalOrder>{erosion::RemovalOrder::Random, "random"},
    Word<erosion::RemovalOrder>{erosion::RemovalOrder::Smallest, "smallest"},
    Word<erosion::RemovalOrder>{erosion::RemovalOrder::LeastStressed, "least-stressed"},
    Word<erosion::RemovalOrder>{erosion::RemovalOrder::FewestContacts, "fewest-contacts"}};

inline constexpr std::array snapshots = {
    Word<Snapshots::When>{Snapshots::When::PerStage, "per-stage"},
    Word<Snapshots::When>{Snapshots::When::Never, "none"}};

inline constexpr std::array extreme = {Word<bool>{false, "minimum"}, Word<bool>{true, "maximum"}};
inline constexpr std::array size_axis = {Word<bool>{false, "left-to-right"}, Word<bool>{true, "reversed"}};
inline constexpr std::array dilation = {Word<bool>{false, "down"}, Word<bool>{true, "up"}};

/// In the order of StageSpec.
inline constexpr auto verbs = [] {
    std::array<std::string_view, stage_traits.size()> words;
    std::transform(stage_traits.begin(), stage_traits.end(), words.begin(), [](const StageTraits& t) {
        return t.verb;
    });
    return words;
}();

inline constexpr std::array<std::string_view, 15> measures = {
    "void-ratios",  "active-fines",      "contact-classes", "strong-contacts", "stress-strain",
    "flow",         "permeability",      "stress",          "constrictions",   "coordination-of-eroded",
    "coordination", "volumetric-strain", "grading",         "porosity",        "skempton-b"};

/// Verbs that a measure belongs to; empty: what every state has.
inline std::vector<std::string> verbs_of_measure(std::string_view measure) {
    std::vector<std::string> list;
    for (const StageTraits& traits : stage_traits) {
        if (traits.has_measure(measure)) {
            list.emplace_back(traits.verb);
        }
    }
    return list;
}

inline constexpr std::array<std::string_view, 3> formats = {"vtp", "xyz", "csv"};

/// All words of a choice.
template <class Words>
std::vector<std::string> words_of(const Words& words) {
    std::vector<std::string> list;
    for (const auto& entry : words) {
        if constexpr (requires { entry.word; }) {
            list.emplace_back(entry.word);
        } else {
            list.emplace_back(entry);
        }
    }
    return list;
}

/// The word that is written for a value.
template <class Words, class Value>
std::string word_for(const Words& words, const Value& value) {
    for (const auto& entry : words) {
        if (entry.value == value) {
            return std::string(entry.word);
        }
    }
    throw Bug("a choice has no word for one of its values");
}

} // namespace suffuse::casefile::names
