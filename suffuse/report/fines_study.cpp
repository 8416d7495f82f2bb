#include "suffuse/report/fines_study.hpp"

#include "suffuse/report/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace suffuse::report {

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

std::string fines_color(double fines_content) {
    using Rgb = std::array<double, 3>;
    // Viridis between its darkest, lost on black, and its brightest, lost on white.
    static constexpr std::array<Rgb, 6> map = {
        {{84, 84, 176}, {48, 120, 160}, {31, 145, 135}, {58, 160, 88}, {122, 160, 35}, {190, 140, 20}}};
    constexpr double stretch = 0.2; // half of the map lies below a fines content of 14 %
    const double whole = 1 / (1 + stretch), f = std::clamp(fines_content, 0.0, 1.0);
    const double place = f / (f + stretch) / whole * (map.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(place), map.size() - 2);
    Rgb color{};
    for (std::size_t c = 0; c < 3; ++c) {
        color[c] = map[k][c] + (place - static_cast<double>(k)) * (map[k + 1][c] - map[k][c]);
    }
    return fmt::format("#{:02x}{:02x}{:02x}", std::lround(color[0]), std::lround(color[1]), std::lround(color[2]));
}

} // namespace suffuse::report
