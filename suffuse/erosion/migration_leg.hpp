#pragma once
// What moves in a migration from one solution of the flow to the next.

#include "suffuse/erosion/grain_water.hpp"
#include "suffuse/erosion/migration.hpp"
#include "suffuse/erosion/passed_throats.hpp"
#include "suffuse/erosion/weighed_copy.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::erosion {

constexpr double departs = 0.5;           ///< from where it rested [diameters]
constexpr double moves = 0.1;             ///< within `still_for`: a grain that is on its way [diameters]
constexpr double nearly_whole = 1 - 1e-9; ///< of a time

/// Fines that are still there, by their number p in a copy: their rows of the ledger.
std::vector<std::size_t> find_present(const MigrationLedger& ledger);

/// A row a grain of the world: 1 where it goes with the water.
std::vector<std::uint8_t> goes_by_row(const dem::World& world, const MigrationLedger& ledger);

/// Factor between a hydraulic gradient under this gravity and one of the flow's, which is of standard gravity.
double strength(const MigrateSpec& spec);

/// On copies, so that it may be stopped.
class Leg {
public:
    Leg(const Migration& before, const MigrateSpec& spec, const Surroundings& around);

    /// Moves until the flow is old, or the budget of steps is spent, for at most `most` of true time [s].
    void go(double time, double most);

    /// Enters what has happened.
    void enter(Migration& migration);

    /// That has gone through the sample [m3].
    [[nodiscard]] double water() const { return discharge_ * flowed_; }

private:
    [[nodiscard]] double diameter(std::size_t p) const { return ledger_.diameter[present_[p]]; }

    [[nodiscard]] bool goes(std::size_t p) const { return ledger_.goes[present_[p]] != 0; }

    [[nodiscard]] bool has_moved(std::size_t p) const;
    [[nodiscard]] Vec3 velocity(std::size_t p) const;
    void look_up_network();

    [[nodiscard]] Vec3 water_at(std::size_t p) const { return speed_ * network_[p]; }

    [[nodiscard]] double speed_of_water() const;
    [[nodiscard]] LayerHeads find_layer_heads() const;
    [[nodiscard]] bool goes_now(std::size_t p) const;
    [[nodiscard]] bool is_flow_old() const;
    void burst(double time);
    void flow_for(double time);
    void note_travel(double time);
    void note_whereabouts();

    const MigrateSpec& spec_;
    Pulse pulse_; ///< with the steps of all legs
    MigrationLedger ledger_;
    std::vector<std::size_t> present_;
    GrainWater water_;
    WeighedCopy copy_;
    CoarseThroats throats_;
    std::vector<Vec3> start_; ///< fines where the flow was solved [m]
    double to_true_;          ///< time of the copy to true time [-]
    double gradient_;         ///< prescribed [-]
    Stack stack_;
    LayerHeads layers_;                 ///< of this flow, over that of the sample, as the network has it
    LayerHeads layers_now_;             ///< with the drag of the grains that move
    LayerHeads layers_flowed_{0, 0, 0}; ///< its integral over time [s]
    double pull_;                       ///< the gradient of the cell, for a flow of standard gravity [-]
    double push_ = 0;                   ///< of the gradient on water and grains of the cell [N]
    double power_ = 0;                  ///< of the network's flow [W]
    double discharge_ = 0;              ///< the same [m3/s]
    double fastest_ = 1;                ///< `speed_` of the flow among the coarse grains alone
    double speed_ = 1;                  ///< of the water over that of the network, as moving grains leave it
    double burst_time_ = 0, took_ = 0;  ///< true [s]
    double flowed_ = 0;                 ///< integral of `speed_` over that time [s]
    std::int64_t most_steps_;           ///< that are left of a budget
    std::vector<Vec3> force_;           ///< of the water on grains at rest [N]
    std::vector<double> rate_;          ///< [1/s]
    std::vector<Vec3> network_;         ///< velocity of its water at each of the fines now [m/s]
};

} // namespace suffuse::erosion
