#pragma once
// What a criterion of internal stability says of a soil: its number, its limit, its verdict, and from where it comes.

#include <optional>
#include <string>
#include <string_view>

namespace suffuse::stability {

enum class Verdict {
    Stable,
    Transition, ///< between the two limits of a criterion that has two
    Unstable,
    CannotSay, ///< the soil lies outside of what the criterion was made for; the reason says how
};

/// On which side of its limit a number means stable.
enum class Sense { AtLeast, AtMost, Between };

/// "at-least", "at-most", "between".
constexpr std::string_view name_of(Sense sense) {
    return sense == Sense::AtLeast ? "at-least" : sense == Sense::AtMost ? "at-most" : "between";
}

struct Criterion {
    std::string id;              ///< "kenney-lau-1986": a promise to scripts
    std::string name;            ///< "Kenney and Lau 1986"
    std::string measure;         ///< what the number is: "(H/F)min"
    std::optional<double> value; ///< [-]; infinite where nothing is to be divided by
    std::optional<double> limit; ///< the soil is stable on the side of `sense` [-]
    std::optional<double> upper; ///< Sense::Between: stable from `limit` to here [-]
    Sense sense = Sense::AtLeast;
    bool strict = false; ///< the limit itself is not stable
    Verdict verdict = Verdict::CannotSay;
    std::string remark;                  ///< where the number was found, or why the criterion cannot say
    std::string source;                  ///< key in docs/references.bib
    bool verified = true;                ///< false: its limits were not read in a source; not part of the summary
    std::optional<double> measured = {}; ///< where a missing end may change the number: that of what was measured
    std::optional<double> diameter;      ///< where on the curve the number was found [m]
};

/// Stable or unstable, as the number stands to its limit; the limit itself, met but for rounding, counts as stable.
inline Verdict judge(const Criterion& criterion) {
    constexpr double rounding = 1e-9;
    const double value = *criterion.value, limit = *criterion.limit;
    const bool reaches = value >= limit * (1 - rounding), stays = value <= limit * (1 + rounding);
    bool is_stable = false;
    switch (criterion.sense) {
    case Sense::AtLeast:
        is_stable = reaches;
        break;
    case Sense::AtMost:
        is_stable = stays;
        break;
    case Sense::Between:
        is_stable = reaches && value <= *criterion.upper * (1 + rounding);
        break;
    }
    return is_stable ? Verdict::Stable : Verdict::Unstable;
}

} // namespace suffuse::stability
