#include "suffuse/study/fines_reason.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <cmath>

namespace suffuse::study {
namespace {

constexpr double kept_within = 0.05; // of e_g: as the criterion of M3

/// Means over the seeds of e_g of the sand alone, and of its change by FC 20 %.
struct Skeleton {
    double sand = 0, change = 0; ///< [-]
};

std::optional<Skeleton> skeleton_of(const StageCurve* loose) {
    if (loose == nullptr) {
        return std::nullopt;
    }
    const ContentCurve e_g = content_curve(*loose, "intergranular_void_ratio");
    Skeleton skeleton;
    int seeds = 0;
    for (std::size_t s = 0; s < e_g.seed.size(); ++s) {
        const auto sand = value_at(e_g, s, 0), later = value_at(e_g, s, 0.2);
        if (sand && later) {
            skeleton.sand += *sand, skeleton.change += *later / *sand - 1;
            ++seeds;
        }
    }
    if (seeds == 0) {
        return std::nullopt;
    }
    skeleton.sand /= seeds, skeleton.change /= seeds;
    return skeleton;
}

std::string describe_skeleton(const Skeleton& skeleton, std::optional<double> size_ratio) {
    const std::string ratio = size_ratio ? fmt::format(" and the size ratio {}", short_number(*size_ratio, 2)) : "";
    if (std::abs(skeleton.change) > kept_within) {
        return fmt::format(
            "This preparation let the skeleton open: at FC 20 % e_g is {} % {} that of the sand alone ({}); the paper "
            "keeps it constant.",
            short_number(100 * std::abs(skeleton.change), 2), skeleton.change > 0 ? "above" : "below",
            short_number(skeleton.sand, 3)
        );
    }
    return fmt::format(
        "The skeleton was kept (e_g within {} % up to FC 20 %). The fines content at which the fines fill its voids "
        "follows from e_g, here {}{}; the paper gives no number for it.",
        std::abs(skeleton.change) < 0.01 ? std::string("1") : short_number(100 * std::abs(skeleton.change), 2),
        short_number(skeleton.sand, 3), ratio
    );
}

} // namespace

void give_reason(const StageCurve* loose, std::optional<double> size_ratio, Finding& finding) {
    const Standing standing = standing_of(finding);
    if (standing == Standing::Met || !finding.why.empty()) {
        return;
    }
    if (standing == Standing::Undecided) {
        finding.why = "The fines contents of this run cannot decide it; add some near the paper's value.";
        return;
    }
    if (standing == Standing::SeedsDisagree) {
        finding.why = "The seeds disagree: their scatter is wider than the margin of the criterion.";
    }
    if (standing == Standing::NotMetByOurNumber) {
        finding.why = fmt::format("The paper's words hold; our number ({}) does not.", list_our_numbers(finding));
    }
    if (const std::optional<Skeleton> skeleton = skeleton_of(loose)) {
        finding.why += (finding.why.empty() ? "" : " ") + describe_skeleton(*skeleton, size_ratio);
    }
}

} // namespace suffuse::study
