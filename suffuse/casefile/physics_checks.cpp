#include "suffuse/casefile/physics_checks.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/casefile/fines_checks.hpp"
#include "suffuse/casefile/sample_checks.hpp"
#include "suffuse/casefile/stack_fields.hpp"
#include "suffuse/casefile/stage_loading.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/casefile/wide_checks.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/erosion/heave.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::casefile {

namespace {

constexpr double large_overlap = 0.02;   ///< of the radius: doubtful [-]
constexpr double largest_overlap = 0.05; ///< of the radius: the contact law no longer describes grains [-]

/// That of a stage that compacts.
std::optional<packing::Protocol> protocol_of(const Stage& stage) {
    const auto* compact = std::get_if<packing::CompactSpec>(&stage.spec);
    return compact == nullptr ? std::nullopt : std::optional(compact->protocol);
}

class Checks {
public:
    Checks(ReadContext& context, const Case& settings, const Study& study, const Variant& variant)
        : context_(context), settings_(settings), variant_(variant), path_("study." + study.name) {}

    void check_pressure(const Stage& stage, std::string_view key, double pressure) {
        const std::optional<TooSoft> soft = check_stiffness(variant_.material, pressure);
        const Place place = stage_place(stage, key);
        if (!soft) {
            check_squeezed(context_.problems, place, std::abs(pressure), variant_, protocol_of(stage));
        } else if (soft->is_error) {
            context_.problems.error("E603", place, soft->message, soft->advice);
        } else {
            context_.problems.warning("W603", place, soft->message, soft->advice);
        }
    }

    void check_protocol(const Stage& stage) {
        casefile::check_protocol(
            context_.problems, stage_place(stage, "protocol"), stage.name, protocol_of(stage).value(), variant_
        );
    }

    void check_adhesion(const Stage& stage, const packing::Prepare& prepare) {
        const bool adheres = prepare.adhesion_normal.value_or(0) > 0 || prepare.adhesion_shear.value_or(0) > 0;
        const contact::Spring& spring = contact::spring_of(variant_.material);
        if (adheres && !spring.may_adhere) {
            context_.problems.error(
                "E207", stage_place(stage, "prepare"),
                fmt::format("grains under the law \"{}\" do not adhere", spring.words.name),
                fmt::format(
                    "leave `adhesion` out: with the final friction from the start a sample is loose too; or take law = "
                    "\"{}\"",
                    contact::laws_that_adhere()
                )
            );
        }
    }

    void check_gradient(const Stage& stage, std::string_view key, double gradient) {
        const double grains = variant_.material.density, fluid = settings_.fluid.density;
        const double critical = (1 - settled_porosity) * (grains / fluid - 1);
        if (!(std::abs(gradient) > critical)) {
            return;
        }
        if (!(critical > 0)) {
            context_.problems.warning(
                "W604", stage_place(stage, key),
                fmt::format(
                    "grains of {} do not sink in a fluid of {}: any gradient lifts them",
                    print_quantity(grains, dimension::density), print_quantity(fluid, dimension::density)
                ),
                "quartz is density = \"2650 kg/m3\" in [grain]; without [gravity] grains have no weight, and the run "
                "will not show that"
            );
            return;
        }
        context_.problems.warning(
            "W604", stage_place(stage, key),
            fmt::format("a gradient of {:.4g} is above the critical one, about {:.2f}", gradient, critical),
            "seepage upwards would lift the whole soil; without [gravity] grains have no weight, and the run will not "
            "show that"
        );
    }

    /// A ramp that begins where the whole soil floats shows nothing of its fines.
    void check_heave(const Stage& stage, const erosion::Gravity& gravity, const Vec3& direction, double first) {
        const std::optional<double> heave = heave_of(gravity, direction);
        if (!heave || first <= *heave) {
            return;
        }
        context_.problems.error(
            "E618", stage_place(stage, "gradients"),
            fmt::format(
                "the gradients begin at {:.4g}, and seepage this way lifts the whole soil at about {:.2f}", first,
                *heave
            ),
            fmt::format("begin lower, as with gradients = {{ up_to = {:.2g}, steps = 24 }}", *heave)
        );
    }

    void check_lift(
        const Stage& stage, std::string_view key, const erosion::Gravity& gravity, const Vec3& direction,
        double gradient
    ) {
        const std::optional<double> heave = heave_of(gravity, direction);
        if (!heave || gradient <= *heave) {
            return;
        }
        context_.problems.warning(
            "W604", stage_place(stage, key),
            fmt::format("a gradient of {:.4g} is above the one of heave, about {:.2f}", gradient, *heave),
            "seepage this way lifts the whole soil; the run holds the coarse grains and finds which fines move"
        );
    }

    /// About, as the sample is not made yet.
    [[nodiscard]] std::optional<double> heave_of(const erosion::Gravity& gravity, const Vec3& direction) const {
        const double critical =
            erosion::critical_gradient(settled_porosity, variant_.material.density, settings_.fluid.density);
        return erosion::heave_gradient(critical, gravity, direction);
    }

    void check_fines(const Stage& stage) {
        casefile::check_fines(context_, variant_, stage, [&](std::string_view key) { return stage_place(stage, key); });
    }

    /// A test, an erosion and a removal start from a sample that carries a stress: the pace or the loads of a test
    /// follow from it. What comes from elsewhere brings one with the forces of its contacts; a cloud has none.
    void check_start(const Stage& stage) {
        const Needs needs = traits_of(stage).needs;
        if (stage.parent < 0 || needs == Needs::Nothing) {
            return;
        }
        const Stage& before = variant_.stages[static_cast<std::size_t>(stage.parent)];
        const Origin origin = traits_of(before).origin;
        const auto* const import = std::get_if<ImportSpec>(&before.spec);
        const bool lacks_forces = import != nullptr && import->contacts.empty() && needs == Needs::Stress;
        if (origin == Origin::Soil || lacks_forces) {
            context_.problems.error(
                "E608", stage_place(stage, "do"),
                fmt::format(
                    "stage \"{}\" starts from the sample of stage \"{}\", which carries no stress yet", stage.name,
                    before.name
                ),
                lacks_forces ? "settle it under a pressure first, or name the file of its `contacts`"
                             : "compact or settle it under a pressure first"
            );
        }
    }

    /// The friction on the way to a void ratio is what all but swift search.
    void check_searched_friction(const Stage& stage, const packing::CompactSpec& compact) {
        const bool is_searched =
            (compact.void_ratio || compact.intergranular_void_ratio) && compact.protocol != packing::Protocol::Swift;
        if (!is_searched || !compact.prepare.friction) {
            return;
        }
        context_.problems.warning(
            "W611", stage_place(stage, "prepare.friction"),
            fmt::format(
                "stage \"{}\" specifies a void ratio, and protocol \"{}\" searches the friction during compaction for "
                "it: the given friction has no effect",
                stage.name, packing::name_of(compact.protocol)
            ),
            "leave `prepare.friction` out, or the void ratio; protocol = \"swift\" keeps to both"
        );
    }

    /// How far grains travel matters where they do.
    void check_travel(const Stage& stage, const erosion::ErodeSpec& erode) {
        if (!erode.transport_distance || erosion::travels(erode)) {
            return;
        }
        context_.problems.warning(
            "W613", stage_place(stage, "passes_constriction.distance"),
            fmt::format("stage \"{}\" sets how far grains have to travel, but they do not travel in it", stage.name),
            "size = \"flow-path\", without `forced`, makes them follow the water"
        );
    }

    /// Layers lie across the flow, and stay so.
    void check_stack(const Stage& stage) { check_in_stack(context_, variant_, stage, stage_place(stage, "do")); }

    /// Skempton's B is that of a fluid.
    void check_fluid(const Stage& stage) {
        if (std::ranges::count(stage.measure, "skempton-b") == 0) {
            return;
        }
        const triaxial::TriaxialSpec* const test = laboratory_test(stage.spec);
        if (test != nullptr && test->path != triaxial::Path::Undrained) {
            context_.problems.error(
                "E207", stage_place(stage, "measure"),
                fmt::format("stage \"{}\" measures Skempton's B, and its test is not undrained", stage.name),
                "take an undrained test, or leave skempton-b out"
            );
        } else if (!settings_.fluid.bulk_modulus) {
            context_.problems.error(
                "E207", stage_place(stage, "measure"),
                fmt::format("stage \"{}\" measures Skempton's B, and [fluid] has no `bulk_modulus`", stage.name),
                "give it, as bulk_modulus = \"2.2 GPa\" of pure water; without it the fluid is incompressible, and B "
                "is 1"
            );
        }
    }

    /// A probe has one flow, and `resolve` requires it on a grid.
    void check_solver(const Stage& stage, const flow::SolverChoice& how) {
        const Place place = stage_place(stage, "solver");
        if (how.resolve && how.solver == flow::Solver::Network && place.source) {
            context_.problems.error(
                "E207", place,
                fmt::format("stage \"{}\" takes the network's flow, and gives a grid for `resolve`", stage.name),
                "take solver = \"resolved\" or \"auto\", or leave `resolve` out"
            );
        }
    }

    /// The flow between the grains themselves is solved in right-angled cells: better reported before the sample is
    /// made.
    void check_resolve(const Stage& stage, const flow::SolverChoice& how) {
        if (!flow::resolves(how)) {
            return;
        }
        for (int k = stage.parent; k >= 0; k = variant_.stages[static_cast<std::size_t>(k)].parent) {
            const Stage& before = variant_.stages[static_cast<std::size_t>(k)];
            const std::optional<cell::Loading> loading = loading_at_end(before.spec);
            if (!loading || !loading->shear_released) {
                continue;
            }
            context_.problems.error(
                "E207", stage_place(stage, how.resolve ? "resolve" : "solver"),
                fmt::format(
                    "stage \"{}\" resolves the flow, which takes a right-angled cell, and stage \"{}\" before it "
                    "releases shear stresses by shearing the cell",
                    stage.name, before.name
                ),
                "take solver = \"network\", without `resolve`: it takes cells of any shape; or keep the shear stresses"
            );
            return;
        }
    }

    [[nodiscard]] Place stage_place(const Stage& stage, std::string_view key) const {
        return place_of(fmt::format("stage.{}.{}", stage.name, key));
    }

    [[nodiscard]] Place place_of(const std::string& key) const {
        const auto found = context_.places.find(path_ + "." + key);
        return found == context_.places.end() ? Place{} : found->second;
    }

private:
    ReadContext& context_;
    const Case& settings_;
    const Variant& variant_;
    std::string path_;
};

void check_loading(Checks& checks, const Stage& stage, const cell::Loading& loading, bool has_pressure) {
    for (const cell::AxisControl& axis : loading.axis) {
        if (axis.control == cell::Control::Stress) {
            checks.check_pressure(stage, has_pressure ? "pressure" : "stress", axis.value);
        }
    }
}

/// What the values of a stage are checked for.
struct CheckValues {
    Checks& checks;
    const Stage& stage;

    void operator()(const ImportSpec&) const {}

    void operator()(const packing::PackSpec&) const {}

    void operator()(const packing::CompactSpec& compact) const {
        checks.check_pressure(stage, "pressure", compact.pressure);
        checks.check_searched_friction(stage, compact);
        checks.check_protocol(stage);
        checks.check_adhesion(stage, compact.prepare);
    }

    void operator()(const dem::SettleSpec& settle) const {
        check_loading(checks, stage, settle.loading, checks.stage_place(stage, "pressure").source != nullptr);
    }

    void operator()(const triaxial::TriaxialSpec& test) const {
        for (const double stress : test.stresses) {
            checks.check_pressure(stage, "stresses", stress);
        }
        if (test.deviator_stress) { // the axial stress is more than that
            checks.check_pressure(stage, "deviator_stress", *test.deviator_stress);
        }
    }

    void operator()(const triaxial::StressProbeSpec&) const {}

    void operator()(const triaxial::StiffnessSpec&) const {}

    void operator()(const dem::AdvanceSpec& advance) const { check_loading(checks, stage, advance.loading, false); }

    void operator()(const flow::FlowSpec& flow) const {
        checks.check_gradient(stage, "gradient", flow.gradient);
        checks.check_resolve(stage, flow.how);
    }

    void operator()(const erosion::DetachStageSpec& detach) const {
        if (detach.probe.gravity) {
            checks.check_heave(stage, *detach.probe.gravity, detach.direction, detach.gradients.front());
        } else {
            for (const double gradient : detach.gradients) {
                checks.check_gradient(stage, "gradients", gradient);
            }
        }
        checks.check_solver(stage, detach.probe.flow);
        checks.check_resolve(stage, detach.probe.flow);
    }

    void operator()(const erosion::ErodeSpec& erode) const {
        for (int pass = 1; pass <= 1 + static_cast<int>(erode.later_passes.size()); ++pass) {
            const double gradient = erosion::at_pass(erode, pass).gradient;
            if (erode.probe.gravity) {
                checks.check_lift(stage, "gradient", *erode.probe.gravity, erode.direction, gradient);
            } else {
                checks.check_gradient(stage, "gradient", gradient);
            }
        }
        checks.check_travel(stage, erode);
        checks.check_solver(stage, erode.probe.flow);
        checks.check_resolve(stage, erode.probe.flow);
    }

    void operator()(const erosion::RemoveSpec&) const {}

    void operator()(const erosion::MigrateSpec& migrate) const {
        if (migrate.gravity && !migrate.gradients.empty()) {
            const double highest = *std::ranges::max_element(migrate.gradients);
            checks.check_lift(stage, "gradients", *migrate.gravity, migrate.direction, highest);
        }
    }
};

void check_stage(Checks& checks, const Stage& stage) {
    std::visit(CheckValues{checks, stage}, stage.spec);
    checks.check_fines(stage);
    checks.check_fluid(stage);
    checks.check_start(stage);
    checks.check_stack(stage);
}

} // namespace

std::optional<TooSoft> check_stiffness(const grains::Material& material, double pressure) {
    const double overlap = contact::mean_overlap_at(material, std::abs(pressure));
    if (overlap <= large_overlap) {
        return std::nullopt;
    }
    return TooSoft{
        fmt::format(
            "a stress of {} makes grains overlap by about {:.1f} % of their radius",
            print_quantity(pressure, dimension::pressure), overlap * 100
        ),
        fmt::format(
            "a stiffer contact `modulus` of {} keeps it below 1 %",
            print_quantity(stiffer_modulus(material, overlap / 0.01), dimension::pressure)
        ),
        overlap > largest_overlap};
}

void check_physics(ReadContext& context, const Case& settings, const Study& study, const Variant& variant) {
    Checks checks(context, settings, study, variant);
    for (const Stage& stage : variant.stages) {
        check_stage(checks, stage);
    }
}

} // namespace suffuse::casefile
