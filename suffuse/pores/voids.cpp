#include "suffuse/pores/voids.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/pores/offset_union.hpp"
#include "suffuse/pores/power_center.hpp"
#include "suffuse/pores/tangent.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace suffuse::pores {
namespace {

constexpr std::size_t block = 1024;

/// Pores too flat for a sphere of their own take that of the first pore of their body that has one.
void share_within_bodies(const PoreNetwork& network, std::vector<VoidSphere>& sphere) {
    const Pores& pores = network.pores;
    constexpr std::uint32_t none = ~std::uint32_t{0};
    std::vector<std::uint32_t> first(network.bodies, none);
    for (std::uint32_t p = 0; p < pores.size(); ++p) {
        if (sphere[p].radius > 0 && first[pores.body[p]] == none) {
            first[pores.body[p]] = p;
        }
    }
    for (std::uint32_t p = 0; p < pores.size(); ++p) {
        const std::uint32_t q = first[pores.body[p]];
        if (sphere[p].radius > 0 || q == none) {
            continue;
        }
        sphere[p] = sphere[q];
        sphere[p].center += shift(network.h, pores.body_image[p] - pores.body_image[q]);
    }
}

bool are_one(const VoidSphere& a, const VoidSphere& b, const Vec3& apart, VoidMerge merge) {
    if (merge == VoidMerge::None || !(a.radius > 0) || !(b.radius > 0)) {
        return false;
    }
    const double reach = merge == VoidMerge::Center ? std::max(a.radius, b.radius) : a.radius + b.radius;
    return norm2(b.center + apart - a.center) < reach * reach;
}

/// A throat from a void to another, `image` periods from it; the first is the one of lower row, so that all throats
/// between the two have the same.
struct Window {
    std::uint32_t one, other;
    cell::Image image;
    std::uint32_t throat;
    Vec3 center; ///< of its circle, as seen from the first void's own place [m]
};

Window window_of(const PoreNetwork& network, std::uint32_t t, const OffsetUnion::Place& a, OffsetUnion::Place b) {
    const Throats& throats = network.throats;
    b.offset = b.offset + throats.image[t];
    const cell::Image between = b.offset - a.offset;
    const bool keep = a.node < b.node || (a.node == b.node && cell::Image{} < between);
    const cell::Image& home = keep ? a.offset : b.offset;
    return {
        keep ? a.node : b.node, keep ? b.node : a.node, keep ? between : -between, t,
        throats.center[t] - shift(network.h, home)};
}

bool coincide(const Throats& throats, const Window& a, const Window& b) {
    const double least = coincidence * std::sqrt(norm(throats.area[a.throat]));
    return std::abs(throats.inscribed_radius[a.throat] - throats.inscribed_radius[b.throat]) <= least &&
           norm(a.center - b.center) <= least;
}

/// One throat of each window: the first of those whose circles coincide.
std::vector<std::uint32_t> one_of_each(const Throats& throats, std::vector<Window> windows) {
    const auto pair_of = [](const Window& w) { return std::tie(w.one, w.other, w.image); };
    std::sort(windows.begin(), windows.end(), [&](const Window& a, const Window& b) {
        return std::tuple_cat(pair_of(a), std::tie(a.throat)) < std::tuple_cat(pair_of(b), std::tie(b.throat));
    });
    std::vector<std::uint32_t> kept;
    for (std::size_t begin = 0, end = 0; begin < windows.size(); begin = end) {
        while (end < windows.size() && pair_of(windows[end]) == pair_of(windows[begin])) {
            ++end;
        }
        for (std::size_t w = begin; w < end; ++w) {
            const bool is_new = std::none_of(
                windows.begin() + static_cast<std::ptrdiff_t>(begin), windows.begin() + static_cast<std::ptrdiff_t>(w),
                [&](const Window& other) { return coincide(throats, windows[w], other); }
            );
            if (is_new) {
                kept.push_back(windows[w].throat);
            }
        }
    }
    std::sort(kept.begin(), kept.end());
    return kept;
}

} // namespace

std::vector<VoidSphere>
void_spheres(const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    const Pores& pores = network.pores;
    std::vector<VoidSphere> sphere(pores.size());
    parallel_for(pores.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p) {
            std::array<Vec3, 4> x;
            std::array<double, 4> r{};
            for (std::size_t k = 0; k < 4; ++k) {
                x[k] = position[pores.grain[p][k]] + shift(network.h, pores.grain_image[p][k]);
                r[k] = radius[pores.grain[p][k]];
            }
            sphere[p] = void_sphere(x, r);
        }
    });
    share_within_bodies(network, sphere);
    return sphere;
}

VoidSphere void_sphere(const std::array<Vec3, 4>& x, const std::array<double, 4>& r) {
    const PowerCenter center = power_center(x, {r[0] * r[0], r[1] * r[1], r[2] * r[2], r[3] * r[3]});
    if (center.is_flat) {
        return {x[0], 0};
    }
    const Vec3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    const Vec3 v = (1 / dot(a, cross(b, c))) *
                   ((r[0] - r[1]) * cross(b, c) + (r[0] - r[2]) * cross(c, a) + (r[0] - r[3]) * cross(a, b));
    const std::optional<double> radius = tangent_size(center.point - x[0], v, r[0]);
    return radius ? VoidSphere{center.point + *radius * v, *radius} : VoidSphere{center.point, 0};
}

std::vector<std::uint32_t> throats_between_voids(
    const PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius, VoidMerge merge
) {
    const Throats& throats = network.throats;
    std::vector<std::uint32_t> between;
    if (merge == VoidMerge::None) {
        for (std::uint32_t t = 0; t < throats.size(); ++t) {
            if (!is_internal(throats, t)) {
                between.push_back(t);
            }
        }
        return between;
    }
    expects(position.size() == radius.size() && !radius.empty(), "voids are merged by the grains of their network");
    const std::vector<VoidSphere> sphere = void_spheres(network, position, radius);
    OffsetUnion voids(network.pores.size());
    std::vector<std::uint32_t> loops; // pores of voids that meet themselves
    for (std::size_t t = 0; t < throats.size(); ++t) {
        const auto [p, q] = throats.side[t];
        if (!is_internal(throats, t) && !are_one(sphere[p], sphere[q], shift(network.h, throats.image[t]), merge)) {
            continue;
        }
        const OffsetUnion::Joined joined = voids.join(p, q, throats.image[t]);
        if (joined.loop != cell::Image{}) {
            loops.push_back(p);
        }
    }
    std::vector<std::uint8_t> runs_through(network.pores.size(), 0); // by root
    for (const std::uint32_t p : loops) {
        runs_through[voids.find(p).node] = 1;
    }
    std::vector<Window> windows;
    for (std::uint32_t t = 0; t < throats.size(); ++t) {
        const OffsetUnion::Place a = voids.find(throats.side[t][0]), b = voids.find(throats.side[t][1]);
        const bool is_inside =
            a.node == b.node && (runs_through[a.node] != 0 || a.offset == b.offset + throats.image[t]);
        if (!is_inside) {
            windows.push_back(window_of(network, t, a, b));
        }
    }
    return one_of_each(throats, std::move(windows));
}

} // namespace suffuse::pores
