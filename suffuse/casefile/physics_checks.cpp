#include "suffuse/casefile/physics_checks.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/erosion/passage.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::casefile {

namespace {

using grains::Grading;
using grains::narrow_cell;

constexpr double settled_porosity = 0.4; ///< of sands at some 100 kPa
constexpr double contacts_per_grain = 4; ///< of the grains that carry load
constexpr double narrowest_cell = 3;     ///< below which a grain meets its own image's neighbors [-]
constexpr double doubtful_width = 0.05;  ///< of an estimated width: what a porosity from 0.3 to 0.48 makes of it
constexpr std::ptrdiff_t few_fines = 100, few_coarse = erosion::fewest_coarse;
constexpr double large_overlap = 0.02;   ///< of the radius: doubtful [-]
constexpr double large_squeezed = 0.1;   ///< of the finest radius: what a run warns of when it is seen [-]
constexpr double wide_grading = 4;       ///< coarsest over finest grain, below which that rule was not looked at
constexpr double largest_overlap = 0.05; ///< of the radius: the contact law no longer describes grains [-]

std::optional<Grading> whole_grading(const grains::Soil& soil) {
    if (soil.whole) {
        return soil.whole;
    }
    if (!soil.coarse || !soil.fines) {
        return std::nullopt;
    }
    return grains::mixture(*soil.coarse, *soil.fines, soil.fines_content);
}

/// Mean volume of a grain when `grading` is drawn by mass: 1 / integral of dF/V over log d, F linear in log d [m3].
double mean_grain_volume(const Grading& grading) {
    double count = 0; // per unit of volume
    for (std::size_t k = 0; k + 1 < grading.diameter.size(); ++k) {
        const double a = grading.diameter[k], b = grading.diameter[k + 1];
        const double share = grading.passing[k + 1] - grading.passing[k];
        count += share * (2 / pi) * (1 / (a * a * a) - 1 / (b * b * b)) / std::log(b / a);
    }
    return count > 0 ? 1 / count : 0;
}

double largest_grain(const Grading& grading) {
    for (std::size_t k = 0; k < grading.diameter.size(); ++k) {
        if (grading.passing[k] >= 1) {
            return grading.diameter[k];
        }
    }
    return grading.diameter.back();
}

/// Width of the settled cell in median diameters of the coarse grains [-]; nothing where there are none.
std::optional<double> skeleton_width(const grains::SampledGrains& sample) {
    std::vector<double> coarse; // [m]
    double solid = 0;           // [m3]
    for (std::size_t g = 0; g < sample.radius.size(); ++g) {
        solid += sphere_volume(sample.radius[g]);
        if (sample.fine[g] == 0) {
            coarse.push_back(2 * sample.radius[g]);
        }
    }
    if (coarse.empty()) {
        return std::nullopt;
    }
    const auto middle = coarse.begin() + std::ssize(coarse) / 2;
    std::nth_element(coarse.begin(), middle, coarse.end());
    return std::cbrt(solid / (1 - settled_porosity)) / *middle;
}

class Checks {
public:
    Checks(ReadContext& context, const Case& settings, const Study& study, const Variant& variant)
        : context_(context), settings_(settings), variant_(variant), path_("study." + study.name) {}

    void check_size(double ratio) {
        const double enough =
            std::ceil(static_cast<double>(variant_.particles) * std::pow(narrow_cell / ratio, 3) / 100) * 100;
        const std::string where = variant_.values.empty() ? "" : fmt::format(" ({} is the narrowest)", variant_.folder);
        const std::string found = fmt::format(
            "{} grains of this soil make a cell {:.1f} times as wide as the largest of them{}",
            grouped(variant_.particles), ratio, where
        );
        const std::string advice =
            fmt::format("{:.0f} times need about {} grains", narrow_cell, grouped(std::llround(enough)));
        const Place place = place_of("particles");
        if (ratio < narrowest_cell) {
            context_.problems.error("E601", place, "a sample too small for its largest grain: " + found, advice);
        } else if (ratio < narrow_cell) {
            context_.problems.warning("W602", place, found, advice);
        }
    }

    void check_pressure(const Stage& stage, std::string_view key, double pressure) {
        const double overlap = overlap_at(std::abs(pressure), variant_.material.modulus);
        if (overlap <= large_overlap) {
            check_squeezed(stage_place(stage, key), std::abs(pressure));
            return;
        }
        const std::string message = fmt::format(
            "a stress of {} makes grains overlap by about {:.1f} % of their radius",
            print_quantity(pressure, dimension::pressure), overlap * 100
        );
        const std::string advice = fmt::format(
            "a stiffer contact `modulus` of {} keeps it below 1 %",
            print_quantity(round_up(variant_.material.modulus * overlap / 0.01), dimension::pressure)
        );
        const Place place = stage_place(stage, key);
        if (overlap > largest_overlap) {
            context_.problems.error("E603", place, message, advice);
        } else {
            context_.problems.warning("W603", place, message, advice);
        }
    }

    /// The finest grains of a wide grading, where the mean overlap is small.
    void check_squeezed(const Place& place, double pressure) {
        const auto grading = variant_.soil ? whole_grading(*variant_.soil) : std::nullopt;
        if (!grading) {
            return;
        }
        const double ratio = largest_grain(*grading) / grains::size_at(*grading, 0);
        const double modulus = variant_.material.modulus, overlap = squeezed_overlap_at(pressure, modulus, ratio);
        if (overlap <= large_squeezed || ratio < wide_grading) {
            return;
        }
        context_.problems.warning(
            "W609", place,
            fmt::format(
                "at {} the finest grains, {:.3g} times smaller than the coarsest, overlap by some {:.0f} % of their "
                "radius where they are caught between those",
                print_quantity(pressure, dimension::pressure), ratio, 100 * overlap
            ),
            fmt::format(
                "a stiffer contact `modulus` of {} makes that some {:.0f} %; steps grow with its root",
                print_quantity(round_up(modulus * overlap / good_squeezed), dimension::pressure), 100 * good_squeezed
            )
        );
    }

    void check_gradient(const Stage& stage, std::string_view key, double gradient) {
        const double critical = (1 - settled_porosity) * (variant_.material.density / settings_.fluid.density - 1);
        if (!(std::abs(gradient) > critical)) {
            return;
        }
        context_.problems.warning(
            "W604", stage_place(stage, key),
            fmt::format("a gradient of {:.4g} is above the critical one, about {:.2f}", gradient, critical),
            "seepage upwards would lift the whole soil; gravity is not part of this model, so the run will not show "
            "that"
        );
    }

    /// Erosion without fines cannot do anything.
    void check_fines(const Stage& stage) {
        const auto& soil = variant_.soil;
        const Place place = stage_place(stage, "do");
        if (!soil) {
            context_.problems.error(
                "E605", place, fmt::format("stage \"{}\" needs to know which grains are fine", stage.name),
                "give the study a `soil` whose `fines` has `finer_than`"
            );
            return;
        }
        const bool has_split = soil->finer_than || soil->kenney_lau || (soil->fines && soil->coarse);
        if (!has_split && soil->whole) {
            context_.problems.error(
                "E605", place, fmt::format("stage \"{}\" erodes a soil without fines", stage.name),
                "give the soil fines = { finer_than = \"0.26 mm\" }"
            );
            return;
        }
        const bool imports = std::any_of(variant_.stages.begin(), variant_.stages.end(), [](const Stage& other) {
            return std::holds_alternative<ImportSpec>(other.spec);
        });
        if (imports && soil->whole) { // of two curves that overlap the packing itself may name its fines
            try {
                grains::fines_limit(*soil);
            } catch (const CaseError& problem) {
                context_.problems.error("E605", place, problem.what(), "suffuse explain E605");
                return;
            }
        }
        const double content = soil->fines_content;
        if (soil->coarse && soil->fines && (content <= 0 || content >= 1)) {
            context_.problems.warning(
                "W605", place,
                fmt::format(
                    "stage \"{}\" erodes a soil of which {} is fine", stage.name,
                    content <= 0 ? "nothing" : "everything"
                ),
                "nothing can leave, or no skeleton stays"
            );
        }
    }

    /// A test loads what a stage before it has loaded; its pace or its loads follow from that stress.
    /// A test, an erosion and a removal start from a sample that carries a stress.
    void check_start(const Stage& stage) {
        if (stage.parent < 0) {
            return;
        }
        const Stage& before = variant_.stages[static_cast<std::size_t>(stage.parent)];
        if (std::holds_alternative<packing::PackSpec>(before.spec) || std::holds_alternative<ImportSpec>(before.spec)) {
            context_.problems.error(
                "E608", stage_place(stage, "do"),
                fmt::format(
                    "stage \"{}\" starts from the sample of stage \"{}\", which carries no stress yet", stage.name,
                    before.name
                ),
                "compact or settle it under a pressure first"
            );
        }
    }

    /// Draws the grains as the run will: a split that does not exist, a curve that so few grains cannot follow.
    void check_sampling() {
        constexpr std::int64_t quickly_drawn = 50'000; // beyond, this would take longer than all other checks together
        if (!whole_grading(*variant_.soil) || variant_.particles < 1 || variant_.particles > quickly_drawn) {
            return;
        }
        try {
            const auto sample = grains::sample_soil(*variant_.soil, static_cast<int>(variant_.particles));
            check_counts(sample);
            check_skeleton(sample);
        } catch (const CaseError& problem) {
            context_.problems.error("E606", place_of("particles"), problem.what(), "suffuse explain E606");
        }
    }

    /// Erosion ends where the coarse skeleton is narrower than it can be judged: better known before the compaction.
    void check_skeleton(const grains::SampledGrains& sample) {
        const bool erodes = std::any_of(variant_.stages.begin(), variant_.stages.end(), [](const Stage& stage) {
            return std::holds_alternative<erosion::ErodeSpec>(stage.spec);
        });
        const auto width = skeleton_width(sample);
        if (!erodes || !width || *width >= erosion::narrowest_skeleton * (1 + doubtful_width)) {
            return;
        }
        constexpr double wanted = erosion::narrowest_skeleton * (1 + doubtful_width);
        const double enough = std::ceil(static_cast<double>(variant_.particles) * std::pow(wanted / *width, 3) / 100);
        context_.problems.warning(
            "W610", place_of("particles"),
            fmt::format(
                "{} grains of this soil{} make a cell some {:.1f} coarse diameters wide: narrower than {:.0f}, erosion "
                "ends with its first pass",
                grouped(variant_.particles), variant_.values.empty() ? "" : fmt::format(" ({})", variant_.folder),
                *width, erosion::narrowest_skeleton
            ),
            fmt::format(
                "take about {} grains or more, or a narrower range of coarse sizes", grouped(100 * std::llround(enough))
            )
        );
    }

    /// What leaves are shares of the fines, held back by the coarse: few of either say little.
    void check_counts(const grains::SampledGrains& sample) {
        const bool erodes = std::any_of(variant_.stages.begin(), variant_.stages.end(), [](const Stage& stage) {
            return std::holds_alternative<erosion::DetachStageSpec>(stage.spec) ||
                   std::holds_alternative<erosion::ErodeSpec>(stage.spec);
        });
        const auto fines = std::count(sample.fine.begin(), sample.fine.end(), std::uint8_t{1});
        const auto coarse = std::ssize(sample.fine) - fines;
        if (!erodes || fines == 0 || coarse == 0) { // where there are none, W605 says so
            return;
        }
        if (fines < few_fines || coarse < few_coarse) {
            context_.problems.warning(
                "W607", place_of("particles"),
                fmt::format(
                    "{} fine grains between {} coarse ones{}: what leaves is then chance, more than soil", fines,
                    coarse, variant_.values.empty() ? "" : fmt::format(" ({})", variant_.folder)
                ),
                fmt::format(
                    "take more grains, until there are at least {} fine and {} coarse, or several seeds (`replicates`)",
                    few_fines, few_coarse
                )
            );
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
    /// To two digits, for advice.
    static double round_up(double value) {
        const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1);
        return std::ceil(value / unit) * unit;
    }

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

void check_stage(Checks& checks, const Stage& stage) {
    if (const auto* compact = std::get_if<packing::CompactSpec>(&stage.spec)) {
        checks.check_pressure(stage, "pressure", compact->pressure);
    } else if (const auto* settle = std::get_if<dem::SettleSpec>(&stage.spec)) {
        check_loading(checks, stage, settle->loading, checks.stage_place(stage, "pressure").source != nullptr);
    } else if (const auto* advance = std::get_if<dem::AdvanceSpec>(&stage.spec)) {
        check_loading(checks, stage, advance->loading, false);
    } else if (std::holds_alternative<triaxial::TriaxialSpec>(stage.spec) ||
               std::holds_alternative<triaxial::StressProbeSpec>(stage.spec)) {
        checks.check_start(stage);
    } else if (const auto* flow = std::get_if<flow::FlowSpec>(&stage.spec)) {
        checks.check_gradient(stage, "gradient", flow->gradient);
    } else if (const auto* detach = std::get_if<erosion::DetachStageSpec>(&stage.spec)) {
        for (const double gradient : detach->gradients) {
            checks.check_gradient(stage, "gradients", gradient);
        }
        checks.check_fines(stage);
    } else if (const auto* erode = std::get_if<erosion::ErodeSpec>(&stage.spec)) {
        checks.check_gradient(stage, "gradient", erode->gradient);
        checks.check_fines(stage);
        checks.check_start(stage);
    } else if (std::holds_alternative<erosion::RemoveSpec>(stage.spec)) {
        checks.check_fines(stage);
        checks.check_start(stage);
    }
}

} // namespace

double width_in_grains(const grains::Soil& soil, std::int64_t particles) {
    const auto grading = whole_grading(soil);
    if (!grading || particles <= 0) {
        return 0;
    }
    const double solid = static_cast<double>(particles) * mean_grain_volume(*grading);
    return std::cbrt(solid / (1 - settled_porosity)) / largest_grain(*grading);
}

double squeezed_overlap_at(double pressure, double modulus, double size_ratio) {
    constexpr double of_chains = 4; // over pressure and modulus: forces of the strongest chains
    return of_chains * pressure / modulus * size_ratio * size_ratio;
}

double overlap_at(double pressure, double modulus) {
    // Mean force p pi D^2/(Z (1 - n)) of equal spheres, over their stiffness E D/2, over their radius D/2.
    return 4 * pi / (contacts_per_grain * (1 - settled_porosity)) * pressure / modulus;
}

void check_physics(ReadContext& context, const Case& settings, const Study& study, const Variant& variant) {
    Checks checks(context, settings, study, variant);
    for (const Stage& stage : variant.stages) {
        check_stage(checks, stage);
    }
}

void check_sample_sizes(ReadContext& context, const Case& settings, const Study& study) {
    const Variant* narrowest = nullptr;
    double least = 0;
    for (const Variant& variant : study.variants) {
        const bool packs = std::any_of(variant.stages.begin(), variant.stages.end(), [](const Stage& stage) {
            return std::holds_alternative<packing::PackSpec>(stage.spec);
        });
        if (packs && variant.soil && variant.replicate == 1) {
            Checks(context, settings, study, variant).check_sampling();
        }
        const double ratio = packs && variant.soil ? width_in_grains(*variant.soil, variant.particles) : 0;
        if (ratio > 0 && (narrowest == nullptr || ratio < least)) {
            narrowest = &variant;
            least = ratio;
        }
    }
    if (narrowest != nullptr) {
        Checks(context, settings, study, *narrowest).check_size(least);
    }
}

} // namespace suffuse::casefile
