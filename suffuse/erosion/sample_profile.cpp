#include "suffuse/erosion/sample_profile.hpp"

#include "suffuse/erosion/planes_across.hpp"
#include "suffuse/erosion/stack.hpp"
#include "suffuse/pores/network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace suffuse::erosion {
namespace {

/// Calls visit(slice, from, to) for each slice of a periodic row that reaches into [low, high], with the slice's
/// bounds next to it.
template <class Visit>
void visit_slices(double low, double high, double step, std::size_t count, Visit&& visit) {
    const auto period = static_cast<long long>(count);
    const auto last = static_cast<long long>(std::floor(high / step));
    for (auto k = static_cast<long long>(std::floor(low / step)); k <= last; ++k) {
        const double from = static_cast<double>(k) * step;
        visit(static_cast<std::size_t>((k % period + period) % period), from, from + step);
    }
}

/// Of all grains or of the fine ones, over the volume of a slice [-].
std::vector<double> solid_of(const dem::World& world, const Vec3& along, const SampleProfile& profile, bool fines) {
    std::vector<double> solid(profile.slices);
    const double slice = cell::volume(world.cell) / static_cast<double>(profile.slices);
    const double step = profile.step.back();
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        if (fines && world.grains.fine[g] == 0) {
            continue;
        }
        const double r = world.grains.radius[g], low = dot(world.grains.position[g], along) - r;
        visit_slices(low, low + 2 * r, step, profile.slices, [&](std::size_t k, double from, double to) {
            solid[k] += (cap_volume(r, to - low) - cap_volume(r, from - low)) / slice;
        });
    }
    return solid;
}

} // namespace

SampleProfile begin_sample_profile(const dem::World& world, const Vec3& direction) {
    SampleProfile profile;
    if (!has_planes_across(world.cell.h, direction)) {
        return profile;
    }
    double largest = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        largest = world.grains.fine[g] == 0 ? std::max(largest, 2 * world.grains.radius[g]) : largest;
    }
    const double length = period_along(world.cell.h, direction);
    profile.slices = static_cast<std::size_t>(std::max(1.0, std::round(length / (0.5 * largest))));
    return profile;
}

std::vector<double> head_shares(const flow::Seepage& seepage, const Vec3& direction, double length, std::size_t count) {
    const Vec3 along = direction / norm(direction);
    const double step = length / static_cast<double>(count);
    std::vector<double> power(count);
    for (std::size_t t = 0; t < seepage.field.flux.size(); ++t) {
        const double flux = seepage.field.flux[t];
        if (flux == 0 || !(seepage.conductance[t] > 0)) {
            continue;
        }
        const double spent = flux * flux / seepage.conductance[t];
        const auto [a, b] = pores::centers_around(seepage.network, t);
        const double from_a = dot(a, along), from_b = dot(b, along);
        const double low = std::min(from_a, from_b), high = std::max(from_a, from_b);
        const double shortest = 1e-9 * step, extent = high - low;
        visit_slices(low, high, step, count, [&](std::size_t k, double from, double to) {
            const double inside = std::min(high, to) - std::max(low, from);
            power[k] += extent > shortest ? spent * inside / extent : from <= low ? spent : 0;
        });
    }
    const double all = std::accumulate(power.begin(), power.end(), 0.0);
    std::ranges::transform(power, power.begin(), [all](double each) { return each / all; });
    return power;
}

void note_sample_profile(
    const dem::World& world, const flow::Seepage& seepage, const Vec3& direction, SampleProfile& profile
) {
    const Vec3 along = direction / norm(direction);
    const double length = period_along(world.cell.h, direction);
    profile.step.push_back(length / static_cast<double>(profile.slices));
    std::vector<double> porosity = solid_of(world, along, profile, false);
    std::ranges::transform(porosity, porosity.begin(), [](double solid) { return 1 - solid; });
    profile.porosity.push_back(std::move(porosity));
    profile.fines.push_back(solid_of(world, along, profile, true));
    std::vector<double> permeability = head_shares(seepage, direction, length, profile.slices);
    for (double& each : permeability) {
        each = seepage.permeability / (each * static_cast<double>(profile.slices));
    }
    profile.permeability.push_back(std::move(permeability));
}

} // namespace suffuse::erosion
