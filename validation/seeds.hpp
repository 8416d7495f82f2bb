#pragma once
// Samples of the gates, one for each seed, and what their seeds scatter by. What the slow way gives is kept in a table,
// for it takes minutes to hours.

#include "suffuse/dem/order.hpp"
#include "suffuse/packing/compact.hpp"
#include "suffuse/packing/seed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace suffuse::validation {

inline constexpr int particles = 2000;

using Row = std::vector<double>; ///< numbers of one seed

struct Preparation {
    const char* name;
    packing::Prepare prepare;
    bool silty =
        false; ///< a sand with 20 % of fines 3.5 times smaller, else the Fontainebleau-like sand of the reference
};

inline grains::Soil soil_of(const Preparation& way) {
    grains::Soil soil;
    if (way.silty) {
        soil.coarse = grains::Grading{{0.28e-3, 0.35e-3, 0.42e-3}, {0, 0.5, 1}, ""};
        soil.fines = grains::Grading{{0.08e-3, 0.10e-3, 0.12e-3}, {0, 0.5, 1}, ""};
        soil.fines_content = 0.20;
    } else {
        soil.whole = grains::Grading{
            {0.10e-3, 0.15e-3, 0.18e-3, 0.21e-3, 0.25e-3, 0.30e-3, 0.40e-3}, {0, 0.08, 0.25, 0.50, 0.75, 0.92, 1}, ""};
    }
    return soil;
}

/// A cloud of porosity 0.62.
inline dem::World cloud(const Preparation& way, std::uint64_t seed) {
    const packing::Cloud made =
        packing::make_cloud(grains::sample_soil(soil_of(way), particles), packing::PackSpec{0.62}, 2600, seed);
    dem::World world;
    world.cell = made.cell;
    world.reference_h = made.cell.h;
    world.grains = made.grains;
    dem::sort_along_curve(world);
    return world;
}

/// Compacts to the pressure. @return the steps it took
inline std::int64_t
prepare(dem::World& world, const packing::CompactSpec& spec, dem::Mode mode = dem::Mode::Reference) {
    dem::StepCaches caches;
    packing::CompactState state = packing::begin_compaction(world, spec, 0.2, mode);
    while (!packing::compact_burst(world, caches, spec, {}, state)) {
    }
    return state.steps;
}

/// Rows of the table with that name in front.
inline std::vector<Row> read_table(const std::string& table, const std::string& name) {
    std::ifstream file(table);
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        std::string cell;
        std::getline(cells, cell, ',');
        if (cell != name) {
            continue;
        }
        Row& row = rows.emplace_back();
        while (std::getline(cells, cell, ',')) {
            row.push_back(std::stod(cell));
        }
    }
    return rows;
}

inline double mean(const std::vector<Row>& rows, std::size_t k) {
    double sum = 0;
    for (const Row& row : rows) {
        sum += row[k];
    }
    return sum / static_cast<double>(rows.size());
}

inline double deviation(const std::vector<Row>& rows, std::size_t k) {
    double square = 0;
    for (const Row& row : rows) {
        square += (row[k] - mean(rows, k)) * (row[k] - mean(rows, k));
    }
    return std::sqrt(square / static_cast<double>(rows.size() - 1));
}

} // namespace suffuse::validation
