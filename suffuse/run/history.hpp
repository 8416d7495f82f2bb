#pragma once
// The history of a stage: one row every so many steps. Names and order of the columns are a promise to users' scripts.

#include "suffuse/base/vec3.hpp"
#include "suffuse/dem/world.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace suffuse::run {

struct HistoryRow {
    std::int64_t step = 0;
    double time = 0;             ///< [s]
    Vec3 strain, stress;         ///< along the axes, compression positive [-], [Pa]
    double void_ratio = 0;       ///< [-]
    double coordination = 0;     ///< 2 contacts / grains [-]
    double unbalanced_force = 0; ///< [-]
    double inertial_number = 0;  ///< of the largest velocity gradient and the median diameter by mass [-]
};

class History {
public:
    /// @param every steps between two rows
    explicit History(std::int64_t every) : every_(every) {}

    /// Steps until the next row is due, at least 1.
    [[nodiscard]] std::int64_t steps_to_next(std::int64_t step) const;

    /// Appends a row when one is due, or when `anyway`.
    void record(const dem::World& world, bool anyway = false);

    /// Another trial of the same stage, from its start.
    void begin_anew() { rows_.clear(); }

    [[nodiscard]] const std::vector<HistoryRow>& rows() const { return rows_; }

    [[nodiscard]] double largest_inertial_number() const;

    void write_csv(const std::filesystem::path& path) const;

    [[nodiscard]] nlohmann::json to_json() const;
    void restore(const nlohmann::json& json);

private:
    std::int64_t every_;
    std::vector<HistoryRow> rows_;
    std::size_t grains_ = 0;     ///< that `median_diameter_` is of
    double median_diameter_ = 0; ///< by mass [m]
};

} // namespace suffuse::run
