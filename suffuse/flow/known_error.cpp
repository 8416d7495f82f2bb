#include "suffuse/flow/known_error.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/flow/seepage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace suffuse::flow {
namespace {

constexpr std::size_t few_fines = 50;
constexpr double little_fines = 0.01;   // of the volume
constexpr double far_overlap = 0.02;    // share of the void covered twice: lattices that overlap by 2 % of a diameter
constexpr double too_far = 0.15;        // beyond, nothing is known
constexpr double channeled = 1.38;      // mixtures are at 1.34 and less, slots and pipes at 1.48 and more ...
constexpr double channeled_open = 1.28; // ... where less than half is solid at 1.24 and at 1.31
constexpr double far_apart = 10;        // size ratio: at 20 the network is 15 % too low
constexpr double one_size = 1.5;        // ratio up to which grains count as of one
constexpr double dense_enough = 0.5;    // solid fraction: below, grains do not touch
constexpr double yade_packing = 0.516;  // the loosest packing of equal grains that Yade's law was tried on

/// Yade's law, equal grains: error of the permeability at a solid fraction (validation/resolved_flow.md).
double yade_error_of_equal_grains(double solid_fraction) {
    constexpr std::array<std::array<double, 2>, 5> seen = {
        {{yade_packing, 0.40}, {0.560, 0.25}, {0.587, 0.16}, {0.611, 0.10}, {0.637, 0.05}}};
    if (solid_fraction <= seen.front()[0]) {
        return seen.front()[1];
    }
    for (std::size_t k = 1; k < seen.size(); ++k) {
        const auto [x0, y0] = seen[k - 1];
        const auto [x1, y1] = seen[k];
        if (solid_fraction < x1) {
            return y0 + (y1 - y0) * (solid_fraction - x0) / (x1 - x0);
        }
    }
    return seen.back()[1];
}

bool is_channeled(const Mixture& mixture) {
    return mixture.channeling > (mixture.solid_fraction < dense_enough ? channeled_open : channeled);
}

KnownError yade_error(const Mixture& mixture) {
    struct Row {
        double up_to = 0;
        KnownError error;
    };

    if (mixture.size_ratio <= one_size) {
        if (mixture.solid_fraction < yade_packing) {
            return {};
        }
        return {yade_error_of_equal_grains(mixture.solid_fraction), std::nullopt, 0.25};
    }
    const std::array<Row, 3> rows = {Row{3.5, {0.5, 0.2, 0.35}}, Row{6.5, {1.5, 0.3, 0.45}}, Row{10, {3.5, 0.4, 0.6}}};
    const auto row = std::ranges::find_if(rows, [&](const Row& each) { return mixture.size_ratio <= each.up_to; });
    return row == rows.end() ? KnownError{} : row->error;
}

} // namespace

std::string_view name_of(Doubt doubt) {
    switch (doubt) {
    case Doubt::None:
        return "";
    case Doubt::FewFines:
        return "fewer than 50 fines";
    case Doubt::LittleFines:
        return "at most 1 % fines";
    case Doubt::Overlaps:
        return "overlaps";
    case Doubt::Channels:
        return "channels";
    case Doubt::RaisedByFines:
        return "fines raise the network's permeability";
    }
    return "";
}

std::string words_of(const FlowSource& source, std::string_view when) {
    if (source.solver != Solver::Network || source.raised_by_fines.value_or(0) <= most_raised) {
        return "";
    }
    return fmt::format(
        "the pore network makes the permeability {} {:.3f} times that of the coarse grains alone, but fines can only "
        "lower it: {}; solver = \"resolved\" solves the flow between the grains, \"auto\" where this is so",
        when, *source.raised_by_fines,
        source.is_limited ? "that of the coarse grains is given" : "it is too high by that at least"
    );
}

std::vector<std::uint8_t> distinguish_fines(std::span<const double> radius) {
    std::vector<double> sorted(radius.begin(), radius.end());
    std::ranges::sort(sorted);
    double widest = 1, least_coarse = 0;
    for (std::size_t k = 1; k < sorted.size(); ++k) {
        if (sorted[k] / sorted[k - 1] > widest) {
            widest = sorted[k] / sorted[k - 1];
            least_coarse = sorted[k];
        }
    }
    std::vector<std::uint8_t> fine(radius.size());
    if (widest >= one_size) {
        std::ranges::transform(radius, fine.begin(), [&](double r) -> std::uint8_t { return r < least_coarse; });
    }
    return fine;
}

Mixture describe_mixture(std::span<const double> radius, std::span<const std::uint8_t> fine, double volume) {
    expects(radius.size() == fine.size(), "one mark a grain");
    Mixture mixture;
    std::array<double, 2> squares{}, cubes{}; // coarse, fine
    for (std::size_t g = 0; g < radius.size(); ++g) {
        const std::size_t kind = fine[g] != 0 ? 1 : 0;
        squares.at(kind) += radius[g] * radius[g];
        cubes.at(kind) += radius[g] * radius[g] * radius[g];
        ++(kind == 1 ? mixture.fines : mixture.coarse);
    }
    const double solids = cubes[0] + cubes[1];
    mixture.solid_fraction = 4 * pi / 3 * solids / volume;
    mixture.fines_content = solids > 0 ? cubes[1] / solids : 0;
    if (mixture.fines > 0 && mixture.coarse > 0) {
        mixture.size_ratio = (cubes[0] / squares[0]) / (cubes[1] / squares[1]);
    }
    return mixture;
}

KnownError known_error(Conductance law, const Mixture& mixture) {
    if (law == Conductance::Yade) {
        return yade_error(mixture);
    }
    if (mixture.overlap > too_far || is_channeled(mixture)) {
        return {};
    }
    if (mixture.overlap > far_overlap) {
        return {0.20, std::nullopt, std::nullopt};
    }
    const bool is_mixed = mixture.size_ratio > one_size;
    if (is_mixed && (mixture.fines_content <= little_fines || mixture.fines < few_fines)) {
        return {0.20, 0.20, 0.40};
    }
    if (mixture.solid_fraction < dense_enough) {
        return {0.12, std::nullopt, std::nullopt};
    }
    return {mixture.size_ratio > far_apart ? 0.20 : 0.12, 0.12, 0.30};
}

std::optional<double> coarse_permeability(
    const cell::Cell& cell, std::span<const Vec3> position, std::span<const double> radius,
    std::span<const std::uint8_t> fine, const Vec3& direction, const Fluid& fluid
) {
    expects(radius.size() == fine.size() && radius.size() == position.size(), "one mark and one place a grain");
    std::vector<Vec3> places;
    std::vector<double> sizes;
    for (std::size_t g = 0; g < radius.size(); ++g) {
        if (fine[g] == 0) {
            places.push_back(position[g]);
            sizes.push_back(radius[g]);
        }
    }
    if (sizes.empty() || sizes.size() == radius.size()) {
        return std::nullopt;
    }
    const double alone = solve_seepage(cell, places, sizes, {1, direction}, fluid).permeability;
    return alone > 0 ? std::optional(alone) : std::nullopt;
}

Doubt doubt_network(const Mixture& mixture, std::optional<double> raised_by_fines) {
    if (mixture.size_ratio > one_size && mixture.fines < few_fines) {
        return Doubt::FewFines;
    }
    if (mixture.size_ratio > one_size && mixture.fines_content <= little_fines) {
        return Doubt::LittleFines;
    }
    if (mixture.overlap > far_overlap) {
        return Doubt::Overlaps;
    }
    if (is_channeled(mixture)) {
        return Doubt::Channels;
    }
    return raised_by_fines.value_or(0) > most_raised ? Doubt::RaisedByFines : Doubt::None;
}

} // namespace suffuse::flow
