#include "suffuse/study/fines_study.hpp"

#include "suffuse/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace suffuse::study {

namespace {

/// What a pure soil has by the definition of the number.
std::optional<double> by_definition(double fines_content, const std::string& name) {
    const bool no_fines = fines_content <= 0, only_fines = fines_content >= 1;
    for (const char* share : {"contact_share.", "strong_contact_share."}) {
        if (name.starts_with(share) && (no_fines || only_fines)) {
            return name.ends_with(no_fines ? ".LL" : ".SS") ? 1.0 : 0.0;
        }
    }
    return std::nullopt;
}

} // namespace

std::string name_of_loose(const StageCurve& loose, const StageCurve& dense) {
    return dense.points.empty() ? fmt::format("state “{}”", loose.stage) : "loose state";
}

Scatter number_of(const SweepPoint& point, double fines_content, const std::string& name) {
    if (const auto found = point.number.find(name); found != point.number.end() && found->second.seeds > 0) {
        return found->second;
    }
    const bool is_void_ratio = name == "intergranular_void_ratio" || name == "equivalent_void_ratio";
    if (is_void_ratio && fines_content <= 0) { // without fines none of them can be counted as voids
        return number_of(point, fines_content, "void_ratio");
    }
    if (const auto value = by_definition(fines_content, name)) {
        return scatter_of(std::vector<double>(std::max<std::size_t>(1, point.seed.size()), *value));
    }
    return scatter_of({});
}

std::string percent_name(double fraction) {
    return short_number(100 * fraction) + " %";
}

std::vector<std::string> fines_colors(const std::vector<double>& contents) {
    using Rgb = std::array<double, 3>;
    // Lightness rises from one to the next; the darkest is not lost on black, nor the brightest on white.
    static constexpr std::array<Rgb, 5> map = {
        {{1, 63, 255}, {181, 27, 128}, {143, 92, 90}, {187, 140, 10}, {143, 157, 112}}};
    const std::set<double> known(contents.begin(), contents.end());
    const std::vector<double> sorted(known.begin(), known.end());
    const double steps = std::max(1.0, static_cast<double>(sorted.size()) - 1);
    std::vector<std::string> colors;
    for (const double content : contents) {
        const auto rank = static_cast<double>(std::ranges::lower_bound(sorted, content) - sorted.begin());
        const double place = rank / steps * (map.size() - 1);
        const std::size_t k = std::min(static_cast<std::size_t>(place), map.size() - 2);
        std::array<long, 3> color{};
        for (std::size_t c = 0; c < 3; ++c) {
            color[c] = std::lround(map[k][c] + (place - static_cast<double>(k)) * (map[k + 1][c] - map[k][c]));
        }
        colors.push_back(fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]));
    }
    return colors;
}

} // namespace suffuse::study
