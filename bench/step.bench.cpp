// Whole time steps on one thread: ns a grain and a contact, by scene and by size.

#include "suffuse/base/parallel.hpp"

#include "bench/per_item.hpp"
#include "bench/scenes.hpp"

namespace suffuse::bench {
namespace {

constexpr int burst = 10; // steps, as stages take them

void measure(benchmark::State& state, Scene scene) {
    const int threads = thread_count();
    set_thread_count(1);
    scene.advance(20);
    const double contacts = scene.contacts();
    for (auto _ : state) {
        scene.advance(burst);
    }
    state.counters["grains"] = scene.grains();
    state.counters["contacts_per_grain"] = contacts / scene.grains();
    state.counters["ns_per_contact"] = ns_per(contacts * burst);
    state.counters["ns_per_grain"] = ns_per(scene.grains() * burst);
    set_thread_count(threads);
}

/// Copies of the 10,000 grains along each axis: cost against size. The largest needs 1.2 GB.
void step_settled(benchmark::State& state) {
    const int copies = static_cast<int>(state.range(0));
    measure(state, compressed("packing10k", copies, copies == 1 ? 2000 : 100));
}

/// The same in fast mode.
void step_settled_fast(benchmark::State& state) {
    const int copies = static_cast<int>(state.range(0));
    measure(state, compressed("packing10k", copies, copies == 1 ? 2000 : 100, dem::Mode::Fast));
}

/// 200,000 grains of a continuous grading: cost against the size ratio.
void step_graded(benchmark::State& state) {
    measure(state, graded(200'000, static_cast<double>(state.range(0))));
}

void step_cubic_lattice(benchmark::State& state) {
    measure(state, cubic_lattice(22));
}

void step_dense_lattice(benchmark::State& state) {
    measure(state, dense_lattice(14));
}

void step_bimodal(benchmark::State& state) {
    measure(state, bimodal(6));
}

BENCHMARK(step_settled)->Arg(1)->Arg(2)->Arg(3)->Arg(5)->MinTime(1);
BENCHMARK(step_settled_fast)->Arg(1)->Arg(5)->MinTime(1);
BENCHMARK(step_graded)->Arg(2)->Arg(10)->Arg(100)->MinTime(1);
BENCHMARK(step_cubic_lattice);
BENCHMARK(step_dense_lattice);
BENCHMARK(step_bimodal);

} // namespace
} // namespace suffuse::bench
