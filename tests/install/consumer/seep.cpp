// seep PACKING EDGE: the permeability of a periodic packing in a cube with this edge [m].
#include "suffuse/suffuse.hpp"

#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
    try {
        if (argc != 3) {
            throw suffuse::UsageError("seep PACKING EDGE");
        }
        const suffuse::cell::Cell cell{.h = std::stod(argv[2]) * suffuse::identity()};
        const suffuse::io::ImportedPacking packing = suffuse::io::read_packing(argv[1], 2650);
        const suffuse::flow::Seepage water =
            suffuse::flow::solve_seepage(cell, packing.grains.position, packing.grains.radius, {.gradient = 0.05}, {});
        std::printf("suffuse %s: %.4e m2\n", suffuse::version().c_str(), water.permeability);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "seep: %s\n", error.what());
        return 1;
    }
}
