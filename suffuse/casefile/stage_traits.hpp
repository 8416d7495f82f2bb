#pragma once
// What sets the verbs of a stage apart: one row a verb, of all that other rooms need without looking at a stage's
// values. What needs the values is a std::visit with an overload for every verb. So a verb that is forgotten does not
// compile.

#include "suffuse/casefile/case.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>

namespace suffuse::casefile {

/// Where a stage has its grains from.
enum class Origin {
    Before, ///< the stage that it starts from
    Soil,   ///< drawn from the soil's curves: a cloud, whose grains touch nowhere
    File    ///< a packing that carries no stress
};

/// What the state must have that a stage starts from.
enum class Needs { Nothing, Contacts, Stress };

/// Each is what a stage does whatever its values are.
struct StageTraits {
    std::string_view verb; ///< the word of a case
    Origin origin = Origin::Before;
    Needs needs = Needs::Nothing;
    bool only_looks = false;       ///< leaves the state as it found it
    bool has_water = false;        ///< what it does depends on the fluid
    bool needs_fines_rule = false; ///< removes fines, or finds which would leave
    bool loses_grains = false;
    bool ends_balanced = false; ///< under the stresses held
    bool keeps_path = false;    ///< a test from its end is the same test as one from its start
    bool is_cached = true;
    std::array<std::string_view, 3> measures = {}; ///< beyond those of every state

    [[nodiscard]] constexpr bool makes_sample() const { return origin != Origin::Before; }

    /// Whether it finds which fines the water would take.
    [[nodiscard]] constexpr bool probes_fines() const { return has_water && needs_fines_rule; }

    /// Whether water takes grains out.
    [[nodiscard]] constexpr bool erodes() const { return has_water && loses_grains; }

    [[nodiscard]] constexpr bool has_measure(std::string_view measure) const {
        return std::find(measures.begin(), measures.end(), measure) != measures.end();
    }
};

/// The row of the stages of one Spec.
template <class Spec>
struct TraitsOf : StageTraits {};

inline constexpr std::tuple stage_rows{
    TraitsOf<ImportSpec>{{.verb = "import", .origin = Origin::File, .is_cached = false}}, // as quickly read as copied
    TraitsOf<packing::PackSpec>{{.verb = "pack", .origin = Origin::Soil}},
    TraitsOf<packing::CompactSpec>{{.verb = "compact", .ends_balanced = true, .measures = {"volumetric-strain"}}},
    TraitsOf<dem::SettleSpec>{
        {.verb = "settle", .ends_balanced = true, .keeps_path = true, .measures = {"volumetric-strain"}}},
    // Whether it ends balanced and keeps its path follows from where it stops.
    TraitsOf<triaxial::TriaxialSpec>{
        {.verb = "triaxial", .needs = Needs::Stress, .measures = {"stress-strain", "volumetric-strain", "skempton-b"}}},
    TraitsOf<triaxial::StressProbeSpec>{
        {.verb = "stress-probe", .needs = Needs::Stress, .only_looks = true, .keeps_path = true}},
    TraitsOf<dem::AdvanceSpec>{{.verb = "advance", .measures = {"volumetric-strain"}}},
    TraitsOf<flow::FlowSpec>{
        {.verb = "flow", .only_looks = true, .has_water = true, .keeps_path = true, .measures = {"flow"}}},
    TraitsOf<erosion::DetachStageSpec>{
        {.verb = "detach",
         .needs = Needs::Contacts,
         .only_looks = true,
         .has_water = true,
         .needs_fines_rule = true,
         .keeps_path = true}},
    TraitsOf<erosion::ErodeSpec>{
        {.verb = "erode",
         .needs = Needs::Stress,
         .has_water = true,
         .needs_fines_rule = true,
         .loses_grains = true,
         .ends_balanced = true,
         .keeps_path = true,
         .measures = {"flow", "coordination-of-eroded", "volumetric-strain"}}},
    TraitsOf<erosion::RemoveSpec>{
        {.verb = "remove",
         .needs = Needs::Stress,
         .needs_fines_rule = true,
         .loses_grains = true,
         .ends_balanced = true,
         .keeps_path = true,
         .measures = {"coordination-of-eroded", "volumetric-strain"}}},
    TraitsOf<triaxial::OedometerSpec>{
        {.verb = "oedometer", .needs = Needs::Stress, .ends_balanced = true, .measures = {"volumetric-strain"}}},
    TraitsOf<triaxial::IsotropicSpec>{
        {.verb = "isotropic", .needs = Needs::Stress, .ends_balanced = true, .measures = {"volumetric-strain"}}},
    TraitsOf<triaxial::PlaneStrainSpec>{
        {.verb = "plane-strain", .needs = Needs::Stress, .measures = {"stress-strain", "volumetric-strain"}}},
    TraitsOf<triaxial::ShearSpec>{{.verb = "shear", .needs = Needs::Stress, .measures = {"volumetric-strain"}}},
    TraitsOf<triaxial::CyclicSpec>{
        {.verb = "cyclic", .needs = Needs::Stress, .measures = {"volumetric-strain", "skempton-b"}}},
    TraitsOf<erosion::MigrateSpec>{
        {.verb = "migrate",
         .needs = Needs::Contacts,
         .has_water = true,
         .needs_fines_rule = true,
         .loses_grains = true,
         .keeps_path = true}},
    TraitsOf<triaxial::StiffnessSpec>{
        {.verb = "stiffness",
         .needs = Needs::Stress,
         .only_looks = true,
         .keeps_path = true,
         .measures = {"skempton-b"}}},
};

namespace detail {

template <class Variant>
struct RowsFor;

template <class... Spec>
struct RowsFor<std::variant<Spec...>> {
    using type = const std::tuple<TraitsOf<Spec>...>;
};

} // namespace detail

static_assert(
    std::is_same_v<decltype(stage_rows), detail::RowsFor<StageSpec>::type>,
    "StageSpec and stage_rows name the same verbs, in the same order"
);

/// The rows without the Specs that they belong to.
inline constexpr auto stage_traits =
    std::apply([](const auto&... row) { return std::array<StageTraits, sizeof...(row)>{row...}; }, stage_rows);

constexpr const StageTraits& traits_of(const StageSpec& spec) {
    return stage_traits[spec.index()];
}

constexpr const StageTraits& traits_of(const Stage& stage) {
    return traits_of(stage.spec);
}

/// Of the verb by its name; nothing where there is none.
constexpr const StageTraits* find_verb(std::string_view verb) {
    const auto row = std::find_if(stage_traits.begin(), stage_traits.end(), [&](const StageTraits& traits) {
        return traits.verb == verb;
    });
    return row == stage_traits.end() ? nullptr : &*row;
}

} // namespace suffuse::casefile
