#include "suffuse/packing/stack.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/random.hpp"
#include "suffuse/packing/overlaps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::packing {
namespace {

constexpr double open_start = 0.8, start_step = 0.05; ///< porosity at which grains are placed, and to the next [-]

/// Factor on the edges of the settled layers.
double widening_at(double porosity) {
    return std::cbrt((1 - layer_porosity) / (1 - porosity));
}

/// All grains of all layers, largest first, with what they are.
struct Rows {
    std::vector<double> radius;
    std::vector<std::size_t> layer;
};

Rows gather(std::span<const LayerSample> layers) {
    Rows all;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        const std::vector<double>& radius = layers[k].grains.radius;
        all.radius.insert(all.radius.end(), radius.begin(), radius.end());
        all.layer.insert(all.layer.end(), radius.size(), k);
    }
    std::vector<std::size_t> order(all.radius.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return all.radius[a] > all.radius[b]; });
    Rows sorted = all;
    for (std::size_t g = 0; g < order.size(); ++g) {
        sorted.radius[g] = all.radius[order[g]];
        sorted.layer[g] = all.layer[order[g]];
    }
    return sorted;
}

/// Between which planes each grain stays, for edges that are so many times the settled ones.
Slabs slabs_at(const Rows& rows, const PackSpec& spec, double widening) {
    std::vector<double> begin{0};
    for (const Layer& layer : spec.layers) {
        begin.push_back(begin.back() + widening * layer.thickness);
    }
    Slabs slabs{.axis = spec.axis, .low = {}, .high = {}};
    for (const std::size_t layer : rows.layer) {
        slabs.low.push_back(begin[layer]);
        slabs.high.push_back(begin[layer + 1]);
    }
    return slabs;
}

Mat3 cell_at(const PackSpec& spec, double widening) {
    double length = 0;
    for (const Layer& layer : spec.layers) {
        length += layer.thickness;
    }
    const double width = spec.width.value_or(0);
    Vec3 edges{width, width, width};
    edges[spec.axis] = length;
    return diagonal(widening * edges);
}

std::vector<Vec3> scatter(const Rows& rows, const Mat3& h, const Slabs& slabs, std::uint64_t seed) {
    std::vector<Vec3> position;
    position.reserve(rows.radius.size());
    for (std::size_t g = 0; g < rows.radius.size(); ++g) {
        RandomStream random(seed, "stack", g);
        const double a = random.uniform(), b = random.uniform(), c = random.uniform();
        const Vec3 share{a, b, c};
        Vec3 x = h * share;
        const double low = slabs.low[g] + rows.radius[g], high = slabs.high[g] - rows.radius[g];
        x[slabs.axis] = low + share[slabs.axis] * (high - low);
        position.push_back(x);
    }
    return position;
}

} // namespace

double solid_of(const Layer& layer, double width) {
    return (1 - layer_porosity) * width * width * layer.thickness;
}

double largest_of(const LayerSample& layer) {
    return 2 * layer.grains.radius.front();
}

LayerSample sample_layer(const grains::Soil& soil, double solid, const Pulse& pulse) {
    constexpr int corrections = 4; // the mean grain depends little on their number
    double count = std::max(1.0, solid * grains::grains_per_volume(grains::specified_grading(soil)));
    LayerSample layer;
    for (int k = 0; k < corrections; ++k) {
        const auto number = static_cast<int>(std::max(1.0, std::round(count)));
        layer.grains = grains::sample_soil(soil, number, pulse);
        layer.solid = 0;
        for (std::size_t g = layer.grains.radius.size(); g-- > 0;) {
            layer.solid += sphere_volume(layer.grains.radius[g]);
        }
        count = number * solid / layer.solid;
        if (std::round(count) == number) {
            break;
        }
    }
    return layer;
}

Cloud make_stack(
    std::span<const LayerSample> layers, const PackSpec& spec, double density, std::uint64_t seed, const Pulse& pulse
) {
    expects(layers.size() == spec.layers.size() && !layers.empty(), "a sample a layer");
    if (!(spec.porosity > 0 && spec.porosity < 1)) {
        throw CaseError(fmt::format("stack: porosity {:.6g} found, expected between 0 and 1", spec.porosity));
    }
    const Rows rows = gather(layers);
    double porosity = std::max(open_start, spec.porosity), widening = widening_at(porosity);
    Slabs slabs = slabs_at(rows, spec, widening);
    Mat3 h = cell_at(spec, widening);
    std::vector<Vec3> position = scatter(rows, h, slabs, seed);
    bool is_clear = clear_overlaps_between(h, rows.radius, position, slabs, default_rounds, pulse);
    while (is_clear && porosity > spec.porosity) {
        porosity = std::max(spec.porosity, porosity - start_step);
        const double closer = widening_at(porosity) / widening;
        widening *= closer;
        for (Vec3& x : position) {
            x *= closer;
        }
        slabs = slabs_at(rows, spec, widening);
        h = cell_at(spec, widening);
        is_clear = clear_overlaps_between(h, rows.radius, position, slabs, default_rounds, pulse);
    }
    if (!is_clear) {
        throw CaseError(fmt::format(
            "stack: {} grains cannot be placed in their layers at porosity {:.3g} without overlaps; take a larger "
            "`porosity`, and compaction does the rest, or thicker layers",
            rows.radius.size(), porosity
        ));
    }
    Cloud cloud;
    cloud.cell.h = h;
    const Mat3 inverse_h = inverse(h);
    for (std::size_t g = 0; g < position.size(); ++g) {
        grains::add_grain(cloud.grains, cell::wrapped(h, inverse_h, position[g]), rows.radius[g], density);
        cloud.grains.fine[g] = rows.layer[g] == 0 ? 1 : 0;
    }
    return cloud;
}

} // namespace suffuse::packing
