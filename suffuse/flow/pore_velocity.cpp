#include "suffuse/flow/pore_velocity.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"

#include <cmath>

namespace suffuse::flow {
namespace {

constexpr double least_void = 0.01; // share of a facet below which it counts as closed: its own centroid will do

} // namespace

Vec3 void_centroid(const std::array<Vec3, 3>& x, const std::array<double, 3>& r) {
    const double area = 0.5 * norm(cross(x[1] - x[0], x[2] - x[0]));
    const Vec3 middle = (1.0 / 3) * (x[0] + x[1] + x[2]);
    double void_area = area;
    Vec3 moment = area * middle;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 left = x[(k + 1) % 3] - x[k], right = x[(k + 2) % 3] - x[k];
        const Vec3 between = left / norm(left) + right / norm(right);
        const double half_angle = 0.5 * std::atan2(2 * area, dot(left, right));
        const double section = half_angle * r[k] * r[k];
        const double arm = 2 * r[k] * std::sin(half_angle) / (3 * half_angle);
        void_area -= section;
        moment -= section * (x[k] + (arm / norm(between)) * between);
    }
    return void_area > least_void * area ? moment / void_area : middle;
}

namespace {

/// Of every throat, in the place that it has next to its side 0.
std::vector<Vec3>
void_centroids(const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius) {
    std::vector<Vec3> place(network.throats.size());
    parallel_for(place.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto [center, r] = pores::spheres_of(network, position, radius, t);
            place[t] = void_centroid(center, r);
        }
    });
    return place;
}

} // namespace

std::vector<Vec3> pore_velocities(
    const pores::PoreNetwork& network, std::span<const Vec3> position, std::span<const double> radius,
    std::span<const double> flux
) {
    const pores::Pores& pores = network.pores;
    const pores::Throats& throats = network.throats;
    expects(flux.size() == throats.size(), "there is a flux for each throat");
    expects(position.size() == radius.size(), "there is a radius for each grain");
    const std::vector<Vec3> place = void_centroids(network, position, radius);
    std::vector<Vec3> outflow(network.bodies); // times its place
    for (std::size_t t = 0; t < throats.size(); ++t) {
        const auto [from, to] = throats.side[t];
        outflow[pores.body[from]] += flux[t] * (place[t] - pores.center[from]);
        outflow[pores.body[to]] -= flux[t] * (place[t] - pores.center[to] - cell::shift(network.h, throats.image[t]));
    }
    std::vector<double> void_volume(network.bodies);
    for (std::size_t p = 0; p < pores.size(); ++p) {
        void_volume[pores.body[p]] += pores.void_volume[p];
    }
    std::vector<Vec3> velocity(pores.size());
    for (std::size_t p = 0; p < pores.size(); ++p) {
        const std::uint32_t body = pores.body[p];
        velocity[p] = void_volume[body] > 0 ? outflow[body] / void_volume[body] : Vec3{};
    }
    return velocity;
}

double tortuosity(const pores::PoreNetwork& network, std::span<const Vec3> velocity) {
    expects(velocity.size() == network.pores.size(), "there is a velocity for each pore");
    double every_way = 0;
    Vec3 one_way;
    for (std::size_t p = 0; p < velocity.size(); ++p) {
        every_way += network.pores.void_volume[p] * norm(velocity[p]);
        one_way += network.pores.void_volume[p] * velocity[p];
    }
    return every_way / norm(one_way);
}

} // namespace suffuse::flow
