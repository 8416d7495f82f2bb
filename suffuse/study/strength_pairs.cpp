#include "suffuse/study/strength_pairs.hpp"

#include "suffuse/casefile/stage_traits.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace suffuse::study {
namespace {

using triaxial::Path;
using triaxial::TriaxialSpec;

bool is_same_test(const TriaxialSpec& a, const TriaxialSpec& b) {
    return a.path == b.path && a.axis == b.axis && a.strain == b.strain && a.strain_ratio == b.strain_ratio &&
           a.direction == b.direction && a.b == b.b && a.inertial_number == b.inertial_number &&
           a.inertia == b.inertia && a.time_step == b.time_step;
}

/// Whether a test from the end of this stage is another than one from its start would be. It is the same after a mere
/// look, and after a part of its own path that stops at a stress: the first to reach it is on the way up, while what
/// was sheared to a strain may be past its peak.
bool leaves_path(const casefile::StageSpec& spec, const TriaxialSpec& test) {
    if (const auto* part = std::get_if<TriaxialSpec>(&spec)) {
        return !part->stops_at_stress() || test.path != Path::Drained || part->path != Path::Drained ||
               part->axis != test.axis || part->direction != test.direction;
    }
    return !casefile::traits_of(spec).keeps_path;
}

/// Share of the mass that a stage took [-]; nothing where it takes none.
std::optional<double> taken_by(const record::FinishedStage& stage) {
    const casefile::StageTraits& traits = casefile::traits_of(*stage.stage);
    if (!traits.loses_grains) {
        return std::nullopt;
    }
    return stage.numbers.value(traits.erodes() ? "eroded_share_of_solids" : "removed_mass_share", std::nan(""));
}

bool skeleton_failed(const record::FinishedStage& stage) {
    const auto& erosion = stage.findings.erosion;
    return stage.numbers.value("failed", false) ||
           (erosion && !erosion->passes.empty() && erosion->passes.back().failed);
}

class Finder {
public:
    explicit Finder(const std::vector<record::FinishedStage>& stages) : stages_(stages) {}

    /// From the second test back to the nearest state before all erosion from which the same test was made.
    [[nodiscard]] std::optional<TestPair> pair_of(const record::FinishedStage& after) const {
        const TriaxialSpec* test = test_of_strength(*after.stage);
        if (test == nullptr || !after.numbers.contains("response") || after.stage->parent < 0) {
            return std::nullopt;
        }
        TestPair pair{nullptr, &after, nullptr, state(after, after.stage->parent), nullptr, 0, false};
        const record::FinishedStage* intact = nullptr;
        double left = 1;
        bool has_failed = false, looks = false;
        for (int row = after.stage->parent; row >= 0;) {
            const record::FinishedStage* stage = state(after, row);
            if (stage == nullptr) {
                break;
            }
            if (const record::FinishedStage* before = looks ? same_test_from(after, row, *test) : nullptr) {
                pair.before = before, pair.tested = stage, pair.intact = intact;
                pair.removed_mass = 1 - left, pair.has_failed = has_failed;
                looks = false;
            }
            if (leaves_path(stage->stage->spec, *test)) {
                break;
            }
            row = stage->stage->parent;
            if (const std::optional<double> share = taken_by(*stage)) {
                left *= 1 - *share;
                has_failed = has_failed || skeleton_failed(*stage);
                looks = true, intact = row < 0 ? nullptr : state(after, row);
            }
        }
        return pair.before != nullptr && pair.intact != nullptr ? std::optional(pair) : std::nullopt;
    }

private:
    [[nodiscard]] const record::FinishedStage* state(const record::FinishedStage& of, int row) const {
        const casefile::Stage* wanted = &of.variant->stages[static_cast<std::size_t>(row)];
        const auto found =
            std::ranges::find_if(stages_, [&](const record::FinishedStage& stage) { return stage.stage == wanted; });
        return found == stages_.end() ? nullptr : &*found;
    }

    [[nodiscard]] const record::FinishedStage*
    same_test_from(const record::FinishedStage& after, int row, const TriaxialSpec& test) const {
        const auto found = std::ranges::find_if(stages_, [&](const record::FinishedStage& stage) {
            const TriaxialSpec* other = test_of_strength(*stage.stage);
            return stage.variant == after.variant && stage.stage->parent == row && other != nullptr &&
                   is_same_test(*other, test) && stage.numbers.contains("response");
        });
        return found == stages_.end() ? nullptr : &*found;
    }

    const std::vector<record::FinishedStage>& stages_;
};

} // namespace

const TriaxialSpec* test_of_strength(const casefile::Stage& stage) {
    const auto* spec = std::get_if<TriaxialSpec>(&stage.spec);
    const bool is_one = spec != nullptr && !spec->stops_at_stress() && spec->path != Path::Proportional &&
                        spec->direction == triaxial::Direction::Compression;
    return is_one ? spec : nullptr;
}

std::vector<TestPair> find_test_pairs(const std::vector<record::FinishedStage>& stages) {
    const Finder finder(stages);
    std::vector<TestPair> pairs;
    for (const record::FinishedStage& stage : stages) {
        if (const std::optional<TestPair> pair = finder.pair_of(stage)) {
            pairs.push_back(*pair);
        }
    }
    return pairs;
}

} // namespace suffuse::study
