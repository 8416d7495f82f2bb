// suffuse_count SCENE N: the work whose instructions bench/instructions.py counts, N times over on one thread. Two runs
// with different N differ by the work alone, without its preparation. Prints what one time is made of, as JSON.

#include "suffuse/base/parallel.hpp"
#include "suffuse/flow/conductance.hpp"
#include "suffuse/flow/pressure.hpp"

#include <nlohmann/json.hpp>

#include "bench/scenes.hpp"
#include <charconv>
#include <iostream>
#include <string_view>

namespace {

using namespace suffuse;

/// Steps of 500 grains that were compressed for a while; contacts and grains come in a fixed proportion.
nlohmann::json count_steps(int n) {
    bench::Scene scene = bench::compressed("packing500", 1, 200);
    scene.advance(n);
    return {{"contact", scene.contacts()}, {"grain", scene.grains()}, {"state", dem::state_hash(scene.world)}};
}

/// Solutions of the flow through 500 grains, with one set-up.
nlohmann::json count_solutions(int n) {
    const dem::World world = test::reference_packing("packing500");
    const pores::PoreNetwork network = pores::build_network(world.cell.h, world.grains.position, world.grains.radius);
    const std::vector<double> conductance = flow::conductances(network, 1e-3);
    const flow::PressureSolver solver(network, conductance);
    int iterations = 0;
    for (int k = 0; k < n; ++k) {
        iterations = solver.solve({0, 0, -1}).iterations;
    }
    return {{"iteration", iterations}, {"pore", network.pores.size()}};
}

} // namespace

int main(int count, char** words) {
    const std::string_view scene = count == 3 ? words[1] : "", number = count == 3 ? words[2] : "";
    int n = 0;
    std::from_chars(number.data(), number.data() + number.size(), n);
    if (n < 1 || (scene != "step" && scene != "flow")) {
        std::cerr << "suffuse_count step|flow N\n";
        return 2;
    }
    set_thread_count(1);
    std::cout << (scene == "step" ? count_steps(n) : count_solutions(n)) << '\n';
    return 0;
}
