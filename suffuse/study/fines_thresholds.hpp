#pragma once
// Fines contents at which a soil changes its character, read off curves over the fines content: where a void ratio is
// lowest (beyond it the fines make the structure [Thevanayagam2000]), and where the fines begin to carry load, the
// break of two straight lines through the rising part of a curve. Each seed has its own curve and its own threshold.

#include "suffuse/study/study_curves.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::study {

/// Fines contents that differ by less are one [-].
inline constexpr double same_content = 1e-9;

/// One number over the fines content.
struct ContentCurve {
    std::vector<double> content;            ///< rising [-]
    std::vector<std::uint64_t> seed;        ///< of the replicates
    std::vector<std::vector<double>> value; ///< [seed][content]; not a number where a sample is missing or has none
};

/// The curve of a number of stage.json; the sweep's first key is the fines content.
ContentCurve content_curve(const StageCurve& stage, const std::string& number);

/// (1 - share) a + share b, point by point; a and b are of the same samples.
ContentCurve blend(const ContentCurve& a, const ContentCurve& b, double share);

/// The value at a fines content that was run; nothing elsewhere.
std::optional<double> value_at(const ContentCurve& curve, std::size_t seed, double content);

/// The lowest or highest point of a curve.
struct Extreme {
    double at = 0;              ///< fines content of the point [-]
    double vertex = 0;          ///< of the parabola through it and its neighbors; `at` at an end of the curve [-]
    double least = 0, most = 0; ///< its neighbors: the true extreme lies between [-]
    bool is_end = false;        ///< the first or last point of the curve

    /// Whether the vertex says more than `at`: not where a neighbor is missing, or so far that it alone would place it.
    [[nodiscard]] bool has_parabola() const;
};

enum class Which { Lowest, Highest };

/// Nothing for fewer than three points.
std::optional<Extreme> find_extreme(const ContentCurve& curve, std::size_t seed, Which which);

/// Where a curve that starts flat begins to rise: the break of two straight lines that fit best its part up to nine
/// tenths of its highest value. Nothing where that part has fewer than four points, does not steepen, or has made a
/// quarter of its rise before the break; nor where all breaks near one end of it fit alike, or one far point alone
/// would place it.
std::optional<double> find_onset(const ContentCurve& curve, std::size_t seed);

/// What determines a threshold.
enum class ThresholdKind {
    LowestLoose,    ///< FC_threshold by the void ratio of the loose state
    LowestBetween,  ///< FC_threshold at a relative density between loose and dense
    LowestDense,    ///< FC_threshold by that of the densest state, e_min
    ActiveFines,    ///< FC_active by the active fines of the loose state
    StrongContacts, ///< FC_active by its strong contacts between coarse and fine grains
};

struct ContentThreshold {
    ThresholdKind kind = ThresholdKind::LowestLoose;
    Scatter at;         ///< fines content [-]; not a number for seeds whose curve has none
    double density = 0; ///< of LowestBetween: share of the way from loose to dense [-]

    [[nodiscard]] bool is_lowest() const {
        return kind != ThresholdKind::ActiveFines && kind != ThresholdKind::StrongContacts;
    }

    /// "FC_threshold", "FC_active": as in summary.json.
    [[nodiscard]] std::string name() const { return is_lowest() ? "FC_threshold" : "FC_active"; }

    /// Where it is read: "lowest void ratio, loose". As in summary.json.
    [[nodiscard]] std::string from() const;
};

/// Null where there is none of this kind.
const ContentThreshold* find_threshold(const std::vector<ContentThreshold>& thresholds, ThresholdKind kind);

/// FC_threshold from the void ratio of the loose and of the dense stage and at relative densities between them,
/// FC_active from the active fines and from the strong contacts of the loose stage. `dense` may be null.
std::vector<ContentThreshold> find_thresholds(const StageCurve& loose, const StageCurve* dense);

} // namespace suffuse::study
