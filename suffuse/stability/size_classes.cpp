#include "suffuse/stability/size_classes.hpp"

#include "suffuse/grains/grading.hpp"

#include <fmt/format.h>

namespace suffuse::stability {

namespace {

using grains::Grading;

/// Passing at a bound, where that is known.
std::optional<double> passing_at(const Grading& grading, double size) {
    if (size < grading.diameter.front()) {
        return grading.passing.front() > 0 ? std::nullopt : std::optional(0.0);
    }
    if (size > grading.diameter.back()) {
        return grading.passing.back() < 1 ? std::nullopt : std::optional(1.0);
    }
    return grains::passing(grading, size);
}

/// Classes from the coarsest on, with the finest size of each.
std::vector<SizeClass> classify(const Grading& grading, std::vector<SizeClass> classes) {
    std::optional<double> above = 1;
    for (SizeClass& one : classes) {
        const auto below = one.finest > 0 ? passing_at(grading, one.finest) : std::optional(0.0);
        one.share = above && below ? std::optional(*above - *below) : std::nullopt;
        above = below;
    }
    return classes;
}

} // namespace

std::vector<SizeClass> astm_classes(const Grading& measured) {
    return classify(
        measured, {{"cobbles", 75e-3, {}}, {"gravel", 4.75e-3, {}}, {"sand", 0.075e-3, {}}, {"fines", 0, {}}}
    );
}

std::vector<SizeClass> iso_classes(const Grading& measured) {
    return classify(
        measured,
        {{"cobbles", 63e-3, {}}, {"gravel", 2e-3, {}}, {"sand", 0.063e-3, {}}, {"silt", 0.002e-3, {}}, {"clay", 0, {}}}
    );
}

std::string classes_text(const std::vector<SizeClass>& classes) {
    std::string text;
    for (const SizeClass& one : classes) {
        if (!one.share || *one.share > 0) {
            text += fmt::format(
                "{}{} {}", text.empty() ? "" : ", ", one.name,
                one.share ? fmt::format("{:.3g} %", 100 * *one.share) : "?"
            );
        }
    }
    return text;
}

} // namespace suffuse::stability
