#include "suffuse/casefile/fines_checks.hpp"

#include "suffuse/casefile/stack_fields.hpp"
#include "suffuse/casefile/stage_traits.hpp"
#include "suffuse/casefile/weight_words.hpp"
#include "suffuse/grains/sampling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::casefile {
namespace {

class FinesChecks {
public:
    FinesChecks(ReadContext& context, const Variant& variant, const Stage& stage, const PlaceOfKey& place)
        : context_(context), variant_(variant), stage_(stage), place_(place) {}

    /// Erosion without fines cannot do anything.
    void check_rule() {
        const auto& soil = variant_.soil;
        const Place place = place_("do");
        if (stack_of(variant_, stage_) != nullptr) {
            return; // the first layer is fine
        }
        if (!soil) {
            context_.problems.error(
                "E605", place, fmt::format("stage \"{}\" needs to know which grains are fine", stage_.name),
                "give the study a `soil` whose `fines` has `finer_than`"
            );
            return;
        }
        const bool has_split = soil->finer_than || soil->kenney_lau || (soil->fines && soil->coarse);
        if (!has_split && soil->whole) {
            context_.problems.error(
                "E605", place, fmt::format("stage \"{}\" erodes a soil without fines", stage_.name),
                "give the soil fines = { finer_than = \"0.26 mm\" }"
            );
            return;
        }
        const bool imports = std::any_of(variant_.stages.begin(), variant_.stages.end(), [](const Stage& other) {
            return traits_of(other).origin == Origin::File;
        });
        if (imports && soil->whole) { // of two curves that overlap the packing itself may name its fines
            try {
                grains::fines_limit(*soil);
            } catch (const CaseError& problem) {
                context_.problems.error("E605", place, problem.what(), "suffuse explain E605");
                return;
            }
        }
        check_both_parts(*soil);
    }

    /// Grains that enter have the sizes of the soil's fines, and enter one soil alone.
    void check_feed(const erosion::MigrateSpec& migrate) {
        const bool is_stack = stack_of(variant_, stage_) != nullptr;
        if (migrate.feed && (is_stack || !variant_.soil)) {
            context_.problems.error(
                "E605", place_("feed"),
                is_stack ? "`feed` lets grains enter a base that is held where the water enters it"
                         : "`feed` lets fines enter, but the study has no soil whose fines these are",
                is_stack ? "leave it out" : "give the study a `soil` with `fines`, or leave `feed` out"
            );
        }
    }

    /// Of two curves: what the mixture has none of.
    void check_both_parts(const grains::Soil& soil) {
        const double content = soil.fines_content;
        if (!soil.coarse || !soil.fines || (content > 0 && content < 1)) {
            return;
        }
        if (!weighs_fines(stage_)) {
            context_.problems.warning(
                "W605", place_("do"),
                fmt::format(
                    "stage \"{}\" erodes a soil of which {} is fine", stage_.name,
                    content <= 0 ? "nothing" : "everything"
                ),
                "nothing can leave, or no skeleton remains"
            );
            return;
        }
        const auto found = context_.places.find(fmt::format("soil.{}.fines_content", variant_.soil_name));
        context_.problems.error(
            "E605", found == context_.places.end() ? place_("do") : found->second,
            fmt::format(
                "stage \"{}\" of {} finds which fines move against their weight, but with `fines_content` = {:.4g} % "
                "the soil has no {}",
                stage_.name, variant_.folder, 100 * content, content <= 0 ? "fines" : "coarse grains"
            ),
            fmt::format(
                "take a value between 0 and 100 %{}",
                variant_.values.empty() ? "" : "; or list in `only` of the stage the swept values that it is to run for"
            )
        );
    }

    /// A stage that takes all fines out leaves none whose weight could be requested.
    void check_fines_left() {
        for (int k = stage_.parent; k >= 0; k = variant_.stages[static_cast<std::size_t>(k)].parent) {
            const Stage& before = variant_.stages[static_cast<std::size_t>(k)];
            const auto* removal = std::get_if<erosion::RemoveSpec>(&before.spec);
            if (removal == nullptr || removal->grains != erosion::RemovedFines::All || removal->share < 1) {
                continue;
            }
            context_.problems.error(
                "E605", place_("do"),
                fmt::format(
                    "stage \"{}\" finds which fines move against their weight, but stage \"{}\" before it removes all "
                    "fines",
                    stage_.name, before.name
                ),
                "start from a stage before it, by `from`; or give the removal a `share` below 100 %"
            );
            return;
        }
    }

private:
    ReadContext& context_;
    const Variant& variant_;
    const Stage& stage_;
    const PlaceOfKey& place_;
};

} // namespace

void check_fines(ReadContext& context, const Variant& variant, const Stage& stage, const PlaceOfKey& place) {
    FinesChecks checks(context, variant, stage, place);
    if (traits_of(stage).needs_fines_rule) {
        checks.check_rule();
    }
    if (weighs_fines(stage)) {
        checks.check_fines_left();
    }
    if (const auto* migrate = std::get_if<erosion::MigrateSpec>(&stage.spec)) {
        checks.check_feed(*migrate);
    }
}

} // namespace suffuse::casefile
