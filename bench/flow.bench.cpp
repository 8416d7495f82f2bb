// The parts of a flow solution on the reference's 10,000 grains, on one thread.

#include "suffuse/base/parallel.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/drag.hpp"
#include "suffuse/flow/pressure.hpp"

#include "bench/per_item.hpp"
#include "tests/support/worlds.hpp"

namespace suffuse::bench {
namespace {

constexpr double viscosity = 1e-3;        // [Pa s]
constexpr Vec3 gradient{0, 0, -490.3325}; // i = 0.05 [Pa/m]

struct Network {
    dem::World world = test::reference_packing("packing10k");
    const Mat3& h = world.cell.h;
    const std::vector<Vec3>& position = world.grains.position;
    const std::vector<double>& radius = world.grains.radius;
    pores::PoreNetwork network = pores::build_network(h, position, radius);
    std::vector<double> conductance = flow::conductances(network, viscosity);

    [[nodiscard]] double throats() const { return static_cast<double>(network.throats.size()); }

    [[nodiscard]] double pores() const { return static_cast<double>(network.pores.size()); }
};

const Network& sample() {
    static const Network made;
    return made;
}

class OneThread {
public:
    OneThread() { set_thread_count(1); }

    ~OneThread() { set_thread_count(before_); }

    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

private:
    int before_ = thread_count();
};

void triangulate(benchmark::State& state) {
    const OneThread one;
    const Network& s = sample();
    for (auto _ : state) {
        benchmark::DoNotOptimize(pores::triangulate(s.h, s.position, s.radius));
    }
    state.counters["ns_per_grain"] = ns_per(static_cast<double>(s.radius.size()));
}

void build_network(benchmark::State& state) {
    const OneThread one;
    const Network& s = sample();
    for (auto _ : state) {
        benchmark::DoNotOptimize(pores::build_network(s.h, s.position, s.radius));
    }
    state.counters["ns_per_throat"] = ns_per(sample().throats());
}

void conductances(benchmark::State& state) {
    const OneThread one;
    for (auto _ : state) {
        benchmark::DoNotOptimize(flow::conductances(sample().network, viscosity));
    }
    state.counters["ns_per_throat"] = ns_per(sample().throats());
}

void set_up_multigrid(benchmark::State& state) {
    const OneThread one;
    for (auto _ : state) {
        benchmark::DoNotOptimize(flow::PressureSolver(sample().network, sample().conductance));
    }
    state.counters["ns_per_pore"] = ns_per(sample().pores());
}

void solve_pressure(benchmark::State& state) {
    const OneThread one;
    const flow::PressureSolver solver(sample().network, sample().conductance);
    int iterations = 0;
    for (auto _ : state) {
        iterations = solver.solve(gradient).iterations;
    }
    state.counters["iterations"] = iterations;
    state.counters["ns_per_pore"] = ns_per(sample().pores());
    state.counters["ns_per_pore_and_iteration"] = ns_per(sample().pores() * iterations);
}

void grain_forces(benchmark::State& state) {
    const OneThread one;
    const flow::FlowField field = flow::solve_pressure(sample().network, sample().conductance, gradient);
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            flow::grain_forces(sample().network, field.pressure, gradient, sample().position, sample().radius)
        );
    }
    state.counters["ns_per_throat"] = ns_per(sample().throats());
}

BENCHMARK(triangulate)->Unit(benchmark::kMillisecond);
BENCHMARK(build_network)->Unit(benchmark::kMillisecond);
BENCHMARK(conductances)->Unit(benchmark::kMillisecond);
BENCHMARK(set_up_multigrid)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_pressure)->Unit(benchmark::kMillisecond);
BENCHMARK(grain_forces)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace suffuse::bench
