#include "suffuse/answer/heave_words.hpp"

#include "suffuse/erosion/heave.hpp"

#include <fmt/format.h>

namespace suffuse::answer {
namespace {

/// A gradient next to the one of heave.
struct Lift {
    double gradient = 0;
    double heave = 1;
    bool has_weight = false;

    [[nodiscard]] double times() const { return gradient / heave; }

    [[nodiscard]] bool lifts() const { return times() >= 1; }
};

class LargestLift {
public:
    explicit LargestLift(double fluid_density) : fluid_density_(fluid_density) {}

    void add(double gradient, const std::optional<double>& heave, bool has_weight) {
        if (heave && *heave > 0 && gradient / *heave > largest_.times()) {
            largest_ = {gradient, *heave, has_weight};
        }
    }

    void add(const record::FinishedStage& stage) {
        if (const auto& erosion = stage.findings.erosion) {
            for (const erosion::PassResult& pass : erosion->passes) {
                if (!study::is_forced(*erosion, pass)) {
                    const bool has_weight = pass.mobility.has_value();
                    add(pass.probe.gradient,
                        has_weight ? pass.mobility->heave_gradient : critical(stage, pass.porosity_before), has_weight);
                }
            }
        }
        if (const auto& mobility = stage.findings.mobility) {
            add(mobility->specified_gradient.value_or(0), mobility->heave_gradient, true);
        }
        for (const erosion::ProbeResult& probe : stage.findings.probes) {
            add(probe.gradient, critical(stage, porosity_of(stage)), false);
        }
        const auto* const spec = std::get_if<erosion::MigrateSpec>(&stage.stage->spec);
        if (spec != nullptr && stage.findings.migration && spec->gravity && !spec->stack) {
            const double critical_gradient = critical(stage, porosity_of(stage));
            for (const erosion::MigrationHold& hold : stage.findings.migration->holds) {
                add(hold.gradient, erosion::heave_gradient(critical_gradient, *spec->gravity, spec->direction), true);
            }
        }
    }

    [[nodiscard]] const Lift& largest() const { return largest_; }

private:
    /// Of the state; 1, which nothing lifts, where it has none.
    static double porosity_of(const record::FinishedStage& stage) {
        const auto found = stage.numbers.find("porosity");
        return found != stage.numbers.end() && found->is_number() ? found->get<double>() : 1;
    }

    [[nodiscard]] double critical(const record::FinishedStage& stage, double porosity) const {
        return erosion::critical_gradient(porosity, stage.variant->material.density, fluid_density_);
    }

    double fluid_density_;
    Lift largest_;
};

} // namespace

std::optional<std::string> doubt_of_heave(const study::RunResults& results) {
    LargestLift lifts(results.what->fluid.density);
    for (const record::FinishedStage& stage : results.stages) {
        lifts.add(stage);
    }
    const Lift& lift = lifts.largest();
    if (!lift.lifts()) {
        return std::nullopt;
    }
    return lift.has_weight
               ? fmt::format(
                     "Flow at i = {:g} is above the gradient that lifts the soil as a whole, {:.2f}: there it heaves, "
                     "and what leaves is more than suffusion.",
                     lift.gradient, lift.heave
                 )
               : fmt::format(
                     "Grains have no weight here. With weight, upward flow at i = {:g} would lift the soil as a whole, "
                     "which heaves at {:.2f} (Terzaghi).",
                     lift.gradient, lift.heave
                 );
}

} // namespace suffuse::answer
