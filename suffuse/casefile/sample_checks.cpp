#include "suffuse/casefile/sample_checks.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/grouped.hpp"
#include "suffuse/base/quantile.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/casefile/weight_words.hpp"
#include "suffuse/erosion/passage.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/grains/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace suffuse::casefile {

namespace {

using grains::Grading;
using grains::narrow_cell;

constexpr double narrowest_cell = 3;    ///< below which a grain meets its own image's neighbors [-]
constexpr double doubtful_width = 0.05; ///< of an estimated width: what a porosity from 0.3 to 0.48 makes of it
constexpr std::ptrdiff_t few_fines = 100, few_coarse = erosion::fewest_coarse;

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
    return std::cbrt(solid / (1 - settled_porosity)) / quantile(std::move(coarse), 0.5);
}

template <class Is>
bool has_stage(const Variant& variant, Is is) {
    return std::ranges::any_of(variant.stages, [&](const Stage& stage) { return is(traits_of(stage)); });
}

/// Of one variant, reported where the case specifies so many grains, or for such fines.
class SampleChecks {
public:
    SampleChecks(ReadContext& context, const Study& study, const Variant& variant)
        : problems_(context.problems),
          place_(context.places["study." + study.name + (study.sample_size ? ".sample_size" : ".particles")]),
          split_place_(
              context.places["soil." + variant.soil_name + (variant.soil->finer_than ? ".fines.finer_than" : ".fines")]
          ),
          variant_(variant) {}

    /// @param ratio width of the cell / largest grain [-]
    void check_width(double ratio) {
        const std::string where = variant_.values.empty() ? "" : fmt::format(" ({} is the narrowest)", variant_.folder);
        const std::string found = fmt::format(
            "the cell of {} grains of this soil is {:.1f} largest-grain diameters wide{}", grouped(variant_.particles),
            ratio, where
        );
        const std::string advice =
            fmt::format("use at least {:.0f} diameters: about {} grains", narrow_cell, enough(narrow_cell / ratio));
        if (ratio < narrowest_cell) {
            problems_.error("E601", place_, "a sample too small for its largest grain: " + found, advice);
        } else if (ratio < narrow_cell) {
            problems_.warning("W602", place_, found, advice);
        }
    }

    /// Draws the grains as the run will: a split that does not exist, a curve that so few grains cannot follow.
    void check_drawn() {
        constexpr std::int64_t quickly_drawn = 50'000; // beyond, this would take longer than all other checks together
        if (!whole_grading(*variant_.soil)) {
            return;
        }
        bool is_split = false;
        try {
            grains::expect_both_parts(*variant_.soil);
            if (variant_.particles < 1 || variant_.particles > quickly_drawn) {
                return;
            }
            is_split = true;
            const auto sample = grains::sample_soil(*variant_.soil, static_cast<int>(variant_.particles));
            check_counts(sample);
            check_skeleton(sample);
        } catch (const CaseError& problem) {
            const bool is_curve = variant_.soil->whole && is_split;
            const char* const help = is_curve ? "or give the soil the key `surrogate`, so that two fractions stand for "
                                                "it, as suffuse new --psd FILE --surrogate does; suffuse explain E606"
                                              : "suffuse explain E606";
            problems_.error("E606", is_split ? place_ : split_place_, problem.what(), help);
        }
    }

private:
    /// What leaves are shares of the fines, held back by the coarse: few of either say little.
    void check_counts(const grains::SampledGrains& sample) {
        const bool erodes = has_stage(variant_, [](const StageTraits& traits) { return traits.probes_fines(); });
        const auto fines = std::count(sample.fine.begin(), sample.fine.end(), std::uint8_t{1});
        const auto coarse = std::ssize(sample.fine) - fines;
        const bool has_both = fines > 0 && coarse > 0;
        if (!has_both) {
            check_weighed(fines > 0);
        }
        if (!erodes || !has_both || (fines >= few_fines && coarse >= few_coarse)) {
            return;
        }
        problems_.warning(
            "W607", place_,
            fmt::format(
                "{} fine grains between {} coarse ones{}: the results then depend more on chance than on the soil",
                fines, coarse, which()
            ),
            fmt::format(
                "take more grains, until there are at least {} fine and {} coarse, or several seeds (`replicates`)",
                few_fines, few_coarse
            )
        );
    }

    /// Of grains that are all fine or all coarse, although the soil has both: too few are drawn of one curve, or of
    /// two.
    void check_weighed(bool all_are_fine) {
        const grains::Soil& soil = *variant_.soil;
        const bool is_known = soil.coarse && soil.fines && (soil.fines_content <= 0 || soil.fines_content >= 1);
        const auto weighed = std::ranges::find_if(variant_.stages, weighs_fines);
        if (is_known || weighed == variant_.stages.end()) { // by E605 at the fines content
            return;
        }
        problems_.error(
            "E605", place_,
            fmt::format(
                "stage \"{}\" finds which fines move against their weight, but all {} grains drawn of this soil{} are "
                "{}",
                weighed->name, grouped(variant_.particles), which(), all_are_fine ? "fine" : "coarse"
            ),
            "take more grains, or another size for `finer_than`, until fines and coarse grains are both there"
        );
    }

    /// Erosion ends where the coarse skeleton is narrower than it can be judged: better known before the compaction.
    void check_skeleton(const grains::SampledGrains& sample) {
        constexpr double wanted = erosion::narrowest_skeleton * (1 + doubtful_width);
        const auto width = skeleton_width(sample);
        const bool erodes =
            has_stage(variant_, [](const StageTraits& traits) { return traits.erodes() && traits.ends_balanced; });
        if (!erodes || !width || *width >= wanted) {
            return;
        }
        problems_.warning(
            "W610", place_,
            fmt::format(
                "{} grains of this soil{} make a cell some {:.1f} coarse diameters wide; below {:.0f} erosion ends "
                "with its first pass",
                grouped(variant_.particles), which(), *width, erosion::narrowest_skeleton
            ),
            fmt::format("take about {} grains or more, or a narrower range of coarse sizes", enough(wanted / *width))
        );
    }

    /// How many grains make a cell so many times as wide, for advice: to the next hundred.
    [[nodiscard]] std::string enough(double times_as_wide) const {
        const double count = static_cast<double>(variant_.particles) * std::pow(times_as_wide, 3);
        return grouped(100 * std::llround(std::ceil(count / 100)));
    }

    /// " (one/fines_content=20)"; empty without a sweep.
    [[nodiscard]] std::string which() const {
        return variant_.values.empty() ? "" : fmt::format(" ({})", variant_.folder);
    }

    Problems& problems_;
    Place place_, split_place_;
    const Variant& variant_;
};

} // namespace

std::optional<Grading> whole_grading(const grains::Soil& soil) {
    if (soil.whole) {
        return soil.whole;
    }
    if (!soil.coarse || !soil.fines) {
        return std::nullopt;
    }
    return grains::mixture(*soil.coarse, *soil.fines, soil.fines_content);
}

double largest_grain(const Grading& grading) {
    for (std::size_t k = 0; k < grading.diameter.size(); ++k) {
        if (grading.passing[k] >= 1) {
            return grading.diameter[k];
        }
    }
    return grading.diameter.back();
}

double width_in_grains(const grains::Soil& soil, std::int64_t particles) {
    const auto grading = whole_grading(soil);
    if (!grading || particles <= 0) {
        return 0;
    }
    const double solid = static_cast<double>(particles) * mean_grain_volume(*grading);
    return std::cbrt(solid / (1 - settled_porosity)) / largest_grain(*grading);
}

void check_sample_sizes(ReadContext& context, const Study& study) {
    const Variant* narrowest = nullptr;
    double least = 0;
    for (const Variant& variant : study.variants) {
        const bool packs = has_stage(variant, [](const StageTraits& traits) { return traits.origin == Origin::Soil; });
        if (!packs || !variant.soil) {
            continue;
        }
        if (variant.replicate == 1) {
            SampleChecks(context, study, variant).check_drawn();
        }
        const double ratio = width_in_grains(*variant.soil, variant.particles);
        if (ratio > 0 && (narrowest == nullptr || ratio < least)) {
            narrowest = &variant;
            least = ratio;
        }
    }
    if (narrowest != nullptr) {
        SampleChecks(context, study, *narrowest).check_width(least);
    }
}

} // namespace suffuse::casefile
