#pragma once
// What erosion did to the strength: a test before fines went and the same test after, on one sample, sample by sample
// (strength_pairs.hpp says what same means); what a test could not show is a remark instead. Compression is
// compared by its deviator stress, a test that holds it by the pore pressure that is borne.

#include "suffuse/record/finished_stage.hpp"
#include "suffuse/study/study_curves.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

/// A number before and after, over the seeds.
struct BeforeAfter {
    Scatter before, after;
    Scatter change; ///< of each seed: relative for stresses, a difference for angles and void ratios
};

/// At one set of sweep values.
struct StrengthChange {
    const casefile::Study* study = nullptr;
    const casefile::Variant* variant = nullptr; ///< of the first seed
    const casefile::Stage* before = nullptr;    ///< the tests, of the first seed
    const casefile::Stage* after = nullptr;
    std::vector<std::uint64_t> seeds;
    Scatter removed_mass;            ///< share of the mass before [-]
    BeforeAfter peak_deviator;       ///< [Pa]
    BeforeAfter final_deviator;      ///< [Pa]
    double reading_strain = 0;       ///< at which deviator_at_strain is read: 10 %, or the end of a shorter test [-]
    BeforeAfter deviator_at_strain;  ///< [Pa]
    BeforeAfter residual_deviator;   ///< of the critical state; none where a test of the pair does not reach it [Pa]
    BeforeAfter critical_void_ratio; ///< there [-]
    BeforeAfter volume_change;       ///< at the end, contraction positive; none where the volume is held [-]
    BeforeAfter friction_angle;      ///< mobilized at the peak [rad]
    BeforeAfter pore_pressure;       ///< the most that is borne where the deviator stress is held; else none [Pa]
    BeforeAfter void_ratio;          ///< before fines went, and where the second test starts [-]
    std::vector<std::string> remarks;

    [[nodiscard]] bool holds_deviator() const;

    /// What measures the strength: the pore pressure or the highest deviator stress [Pa].
    [[nodiscard]] const BeforeAfter& borne() const { return holds_deviator() ? pore_pressure : peak_deviator; }

    /// By what is borne; nothing where the change is none compared with the scatter of samples.
    [[nodiscard]] std::optional<bool> is_weaker() const;
};

/// In the order of the stages. Tests that stop at a stress are none of strength.
std::vector<StrengthChange> compare_strength(const std::vector<record::FinishedStage>& stages);

/// As in summary.json.
nlohmann::json strength_json(const std::vector<StrengthChange>& changes);

} // namespace suffuse::study
