// The neighbor search against the size ratio. Grains lie at random (they may overlap: the search does not mind) at a
// solid fraction of 0.6, every size with the same mass.

#include "suffuse/base/constants.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include "bench/per_item.hpp"
#include <cmath>
#include <random>

namespace suffuse::bench {
namespace {

void find_pairs(benchmark::State& state) {
    constexpr std::size_t grains = 20'000;
    constexpr double smallest = 1e-4;
    const auto ratio = static_cast<double>(state.range(0));
    std::mt19937_64 random(1);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    std::vector<double> radius(grains);
    double solid = 0;
    for (double& r : radius) {
        r = smallest * std::cbrt(1 / (1 - uniform() * (1 - std::pow(ratio, -3))));
        solid += sphere_volume(r);
    }
    const double edge = std::cbrt(solid / 0.6);
    std::vector<Vec3> position(grains);
    for (Vec3& x : position) {
        x = edge * Vec3{uniform(), uniform(), uniform()};
    }
    const int threads = thread_count();
    set_thread_count(1);
    std::size_t pairs = 0;
    for (auto _ : state) {
        pairs = neighbors::find_pairs(diagonal({edge, edge, edge}), position, radius, 0.1 * smallest).size();
    }
    set_thread_count(threads);
    state.counters["pairs_per_grain"] = static_cast<double>(pairs) / grains;
    state.counters["ns_per_grain"] = ns_per(grains);
    state.counters["ns_per_pair"] = ns_per(static_cast<double>(pairs));
}

BENCHMARK(find_pairs)->Arg(1)->Arg(4)->Arg(20)->Arg(100);

} // namespace
} // namespace suffuse::bench
