#pragma once
// A copy of a sample whose free fines have weight: coarse grains are held, and with them the fines that carry the
// skeleton's forces. Weight and seepage are scaled up alike (weight.hpp). Free fines that have come to rest among
// others that rest are held, too, until something moves next to them or the load changes: they sleep.

#include "suffuse/base/pulse.hpp"
#include "suffuse/dem/stable_dt.hpp"
#include "suffuse/dem/step.hpp"
#include "suffuse/dem/world.hpp"
#include "suffuse/erosion/weight.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace suffuse::erosion {

/// A contact that presses a fine grain with more than this times its weight is one of the skeleton.
inline constexpr double load_of_skeleton = 100;

class WeighedCopy {
public:
    /// @param weight of each grain, less buoyancy [N]; @param motion and load_over_weight: see scale_weight
    /// @param held a row a grain, 1 for what never moves; empty: coarse grains, and fines that bear the skeleton's load
    WeighedCopy(
        const dem::World& sample, std::vector<Vec3> weight, const WeighedMotion& motion, double load_over_weight = 1,
        const std::vector<std::uint8_t>& held = {}
    );

    /// Goes on from the `whole` of another copy: what is held there carries the skeleton.
    WeighedCopy(dem::World whole, const WeightScale& scale, std::vector<Vec3> weight);

    /// Lets weight act, and `share` of the given force on each grain [N], if any, from now on. All are awake.
    void load(std::span<const Vec3> force, double share);

    /// The same in water that drags each grain by its own rate [1/s], in true time, and in which nothing else damps its
    /// motion. @param force of the water on each grain at rest [N]; @param rate of each grain
    void immerse(std::span<const Vec3> force, std::span<const double> rate);

    /// Until the load changes, drags the grains so that what is pressed gets apart and nothing flies.
    void brake();

    /// True time that passes in one unit of hold(): forces are scaled up and masses are not, so that the copy moves as
    /// grains with contacts softer by scale().factor do, in a time shorter by its root [s].
    [[nodiscard]] double true_time() const;

    /// Moves on under the load, for a time in units of scale().time.
    void hold(double time, const Pulse& pulse, std::string_view part);

    /// All are awake. @return the world with the skeleton's own contacts, which world() lacks: what moves on from there
    /// moves to the same bits
    [[nodiscard]] dem::World whole();

    [[nodiscard]] const dem::World& world() const { return world_; }

    [[nodiscard]] const WeightScale& scale() const { return scale_; }

    [[nodiscard]] double time_step() const { return step_.time_step; }

    [[nodiscard]] std::int64_t steps() const { return steps_; } ///< made so far

    /// Of row `g` of the grain table [N].
    [[nodiscard]] const Vec3& weight(std::uint32_t g) const { return weight_[g]; }

    [[nodiscard]] const std::vector<std::uint32_t>& fines() const { return fines_; } ///< rows of the grain table

    // Of the fines, by their number k in fines().
    [[nodiscard]] bool bears_load(std::size_t k) const { return bears_load_[k] != 0; }

    [[nodiscard]] const Vec3& position(std::size_t k) const { return world_.grains.position[fines_[k]]; }

    [[nodiscard]] std::vector<Vec3> positions() const;

    [[nodiscard]] std::int64_t free_count() const { return free_; }

private:
    void wake();
    void put_to_sleep(const std::vector<Vec3>& before, double time);
    void renew_time_step();

    dem::World world_;
    contact::Contacts skeleton_; ///< between grains of which none will ever move
    contact::Contacts resting_;  ///< between others of which none moves now
    bool some_sleep_ = false;
    std::vector<Vec3> weight_; ///< [N]
    std::vector<std::uint32_t> fines_;
    std::vector<std::uint8_t> bears_load_;
    std::int64_t free_ = 0;
    WeightScale scale_;
    dem::StepCaches caches_;
    grains::GrainLoad load_;
    double drag_ = 0;       ///< viscous, the largest of all grains [1/s]
    double damping_ = 0;    ///< local [-]
    double loaded_for_ = 0; ///< in units of scale().time
    dem::ComputedStep step_;
    std::int64_t steps_ = 0;
};

} // namespace suffuse::erosion
