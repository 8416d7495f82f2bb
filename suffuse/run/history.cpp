#include "suffuse/run/history.hpp"

#include "suffuse/dem/equilibrium.hpp"
#include "suffuse/dem/inertial_number.hpp"
#include "suffuse/dem/inspect.hpp"
#include "suffuse/grains/gradation.hpp"
#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/result_json.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::run {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    HistoryRow, step, time, strain, stress, void_ratio, coordination, unbalanced_force, inertial_number
)

namespace {

double largest_component(const Mat3& m) {
    double largest = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
            largest = std::max(largest, std::abs(m(a, b)));
        }
    }
    return largest;
}

} // namespace

std::int64_t History::steps_to_next(std::int64_t step) const {
    const std::int64_t last = rows_.empty() ? step : rows_.back().step;
    return std::max<std::int64_t>(1, last + every_ - step);
}

void History::record(const dem::World& world, bool anyway) {
    const std::int64_t step = world.clock.step;
    if (!rows_.empty() && rows_.back().step == step) {
        return;
    }
    if (!anyway && !rows_.empty() && step < rows_.back().step + every_) {
        return;
    }
    if (grains_ != world.grains.size()) { // sizes of grains never change, but grains are taken out
        grains_ = world.grains.size();
        median_diameter_ = grains::median_diameter(world.grains);
    }
    const Mat3 stress = dem::mean_stress_tensor(world);
    const dem::Equilibrium balance = dem::measure_equilibrium(world);
    rows_.push_back(
        {step,
         world.clock.time,
         dem::strain(world),
         {stress(0, 0), stress(1, 1), stress(2, 2)},
         dem::void_ratio(world),
         2 * static_cast<double>(balance.contacts) / static_cast<double>(std::max<std::size_t>(1, world.grains.size())),
         balance.unbalanced_force,
         dem::inertial_number(
             largest_component(world.cell.velocity_gradient), median_diameter_, world.material.density,
             dem::mean_stress(stress)
         )}
    );
}

double History::largest_inertial_number() const {
    double largest = 0;
    for (const HistoryRow& row : rows_) {
        largest = std::max(largest, row.inertial_number);
    }
    return largest;
}

void History::write_csv(const std::filesystem::path& path) const {
    io::CsvWriter file(
        path,
        "step,time,strain_1,strain_2,strain_3,stress_1,stress_2,stress_3,void_ratio,coordination,unbalanced_force,"
        "inertial_number"
    );
    for (const HistoryRow& row : rows_) {
        file.row(
            row.step, row.time, row.strain, row.stress, row.void_ratio, row.coordination, row.unbalanced_force,
            row.inertial_number
        );
    }
    file.finish();
}

nlohmann::json History::to_json() const {
    return rows_;
}

void History::restore(const nlohmann::json& json) {
    rows_ = json.get<std::vector<HistoryRow>>();
}

} // namespace suffuse::run
