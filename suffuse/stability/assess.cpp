#include "suffuse/stability/assess.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/grains/grading.hpp"
#include "suffuse/stability/burenkova.hpp"
#include "suffuse/stability/chang_zhang.hpp"
#include "suffuse/stability/filter_ratio.hpp"
#include "suffuse/stability/kenney_lau.hpp"

#include <fmt/format.h>

namespace suffuse::stability {

using grains::Grading;

namespace {

void require(bool condition, const std::string& message) {
    if (!condition) {
        throw CaseError(message);
    }
}

void check(const AssessSpec& spec) {
    if (spec.relative_density) {
        const double density = *spec.relative_density;
        require(
            density >= 0 && density <= 1,
            fmt::format("a relative density of {:.6g}: it must be between 0 (loosest) and 1 (densest)", density)
        );
    }
    if (!spec.seepage) {
        return;
    }
    const Seepage& seepage = *spec.seepage;
    require(seepage.gradient >= 0, fmt::format("a hydraulic gradient of {:.6g}: it is 0 or more", seepage.gradient));
    require(
        seepage.porosity > 0 && seepage.porosity < 1,
        fmt::format("a porosity of {:.6g}: it must be between 0 and 1, for soils usually 0.2 to 0.6", seepage.porosity)
    );
    require(
        seepage.grain_density > 1000,
        fmt::format(
            "a density of the grains of {:.6g} kg/m^3: grains that sink are denser than 1000, quartz has 2650",
            seepage.grain_density
        )
    );
    if (seepage.stress_share) {
        require(
            *seepage.stress_share >= 0 && *seepage.stress_share <= 1,
            fmt::format(
                "an alpha of {:.6g}: it must be between 0 and 1; 1 stands for fines that carry the mean stress or more",
                *seepage.stress_share
            )
        );
    }
}

double uniformity_of(const Grading& grading, PrimaryFabric fabric, const std::optional<FineFraction>& fines) {
    const bool coarse_alone = fabric == PrimaryFabric::Coarse && fines;
    return grains::uniformity(coarse_alone ? coarse_part(grading, fines->finer_than) : grading);
}

std::string names_with(const std::vector<Criterion>& criteria, Verdict verdict) {
    std::string names;
    for (const Criterion& criterion : criteria) {
        if (criterion.verified && criterion.verdict == verdict) {
            names += names.empty() ? "" : ", ";
            names += criterion.name;
        }
    }
    return names;
}

} // namespace

Assessment assess(const Grading& grading, const AssessSpec& spec) {
    grains::check(grading);
    check(spec);
    Assessment assessment;
    assessment.grading = grading;
    assessment.gap = find_gap(grading);
    assessment.fines = find_fine_fraction(grading, assessment.gap, spec.finer_than);
    const std::optional<FineFraction>& fines = assessment.fines;
    assessment.finer_limit = finer_limit(uniformity_of(grading, spec.fabric, fines));
    const double limit = assessment.finer_limit;
    assessment.constrictions =
        compare_with_constrictions(grading, fines, least_shape_ratio(grading, limit).at.diameter);
    assessment.criteria = {
        kenney_lau_1985(grading, limit),
        kenney_lau_1986(grading, limit),
        li_fannin(grading, limit),
        kezdi(grading),
        burenkova(grading),
        wan_fell(grading, fines),
        chang_zhang(grading, limit),
        sherard(grading, fines),
        wan_fell_alternative(grading, fines),
        indraratna(assessment.constrictions, spec.relative_density)};
    if (spec.seepage && spec.seepage->lifts()) {
        assessment.gradients = {
            terzaghi(*spec.seepage), skempton_brogan(*spec.seepage, assessment.criteria[kenney_lau_1985_row].verdict)};
    }
    return assessment;
}

Tally count_verdicts(const std::vector<Criterion>& criteria) {
    Tally tally;
    for (const Criterion& criterion : criteria) {
        if (!criterion.verified) {
            ++tally.unverified;
            continue;
        }
        switch (criterion.verdict) {
        case Verdict::Stable:
            ++tally.stable;
            break;
        case Verdict::Transition:
            ++tally.transition;
            break;
        case Verdict::Unstable:
            ++tally.unstable;
            break;
        case Verdict::CannotSay:
            ++tally.cannot_say;
            break;
        }
    }
    return tally;
}

const char* verdict_word(Verdict verdict) {
    switch (verdict) {
    case Verdict::Stable:
        return "stable";
    case Verdict::Transition:
        return "transition";
    case Verdict::Unstable:
        return "unstable";
    case Verdict::CannotSay:
        break;
    }
    return "cannot say";
}

std::string limit_text(const Criterion& criterion) {
    if (!criterion.limit) {
        return {};
    }
    if (criterion.upper) {
        return fmt::format("{:.3g} to {:.3g}", *criterion.limit, *criterion.upper);
    }
    const char* side = criterion.sense == Sense::AtMost ? "<" : ">";
    return fmt::format("{}{} {:.3g}", side, criterion.strict ? "" : "=", *criterion.limit);
}

std::string summary(const std::vector<Criterion>& criteria) {
    const Tally tally = count_verdicts(criteria);
    const int counted = tally.stable + tally.transition + tally.unstable;
    std::string text;
    const auto add = [&](int count, Verdict verdict) {
        if (count > 0) {
            text += fmt::format(
                "{}{} ({})",
                text.empty() ? fmt::format("{} of {} criteria say ", count, counted) : fmt::format(", {} ", count),
                verdict_word(verdict), names_with(criteria, verdict)
            );
        }
    };
    add(tally.unstable, Verdict::Unstable);
    add(tally.transition, Verdict::Transition);
    add(tally.stable, Verdict::Stable);
    if (counted == 0) {
        text = "none of the criteria can say";
    } else if (tally.cannot_say > 0) {
        text += fmt::format("; cannot say: {}", names_with(criteria, Verdict::CannotSay));
    }
    return text;
}

} // namespace suffuse::stability
