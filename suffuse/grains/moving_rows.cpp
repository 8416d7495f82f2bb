#include "suffuse/grains/moving_rows.hpp"

#include "suffuse/base/large_pages.hpp"
#include "suffuse/base/parallel.hpp"

namespace suffuse::grains {
namespace {

constexpr std::size_t block_rows = 2048;

}

void to_rows(const Grains& grains, std::vector<MovingRow>& rows) {
    reserve_in_large_pages(rows, grains.size());
    rows.resize(grains.size());
    parallel_for(grains.size(), block_rows, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            const double free = grains.motion[g] == Motion::Free ? 1.0 : 0.0;
            rows[g] = {
                double4(grains.position[g], free / grains.mass[g]),
                double4(grains.velocity[g], free / grains.inertia[g]), double4(grains.spin[g], grains.radius[g])};
        }
    });
}

void from_rows(const std::vector<MovingRow>& rows, Grains& grains) {
    resize_columns(grains.size(), grains.position, grains.velocity, grains.spin);
    parallel_for(grains.size(), block_rows, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            grains.position[g] = xyz(rows[g].position);
            grains.velocity[g] = xyz(rows[g].velocity);
            grains.spin[g] = xyz(rows[g].spin);
        }
    });
}

void from_sums(const std::vector<GrainSum>& sums, Grains& grains) {
    resize_columns(grains.size(), grains.force, grains.torque);
    parallel_for(grains.size(), block_rows, [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
            grains.force[g] = xyz(sums[g].force);
            grains.torque[g] = xyz(sums[g].torque);
        }
    });
}

} // namespace suffuse::grains
