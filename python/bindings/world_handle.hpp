#pragma once
// A world as Python holds it, and NumPy arrays that look into it without copying. An array keeps alive what it looks
// into. Where rows are about to be added, removed or reordered while arrays look at them, those arrays keep the old
// rows, to themselves, and the world goes on with new ones: nobody ever looks at freed memory. While a call steps a
// world, other threads of Python are refused: they would read what is half done. The caller holds the interpreter.

#include "suffuse/dem/step.hpp"
#include "suffuse/grains/soil.hpp"

#include <memory>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

namespace suffuse::python {

class WorldHandle {
public:
    explicit WorldHandle(dem::World world) : world_(std::move(world)), density_(world_.material.density) {}

    WorldHandle(const WorldHandle&) = delete;
    WorldHandle& operator=(const WorldHandle&) = delete;

    /// To look at. @throws StateError while a call steps it and is not just telling its progress.
    [[nodiscard]] const dem::World& world() const;

    /// For changes that leave every column where it is. @throws StateError likewise
    [[nodiscard]] dem::World& world();

    /// For changes of the rows. @throws StateError while a call steps or reads it, even where that shows its progress
    dem::World& world_for_new_rows();

    /// Kept alive by arrays, next to the handle itself: the rows that they look into once the world has moved on.
    [[nodiscard]] std::shared_ptr<const void> rows_of_views() const { return kept_; }

    /// Whether it may be looked at now.
    [[nodiscard]] bool is_open() const { return !steps_ || pauses_; }

private:
    friend class Stepping;
    friend class Reading;

    [[noreturn]] static void refuse();
    void refuse_unless_open() const;

    dem::World& part_from_views();

    /// Python may set the density of the material that it was given to look at: the masses are then another density's.
    void follow_density() const;

    mutable dem::World world_;
    mutable dem::StepCaches caches_;
    mutable double density_;                ///< that masses and inertia are of [kg/m3]
    std::vector<Vec3> position_, velocity_; ///< after the last step
    Mat3 h_{};
    std::shared_ptr<grains::Grains> kept_ = std::make_shared<grains::Grains>();
    double stable_step_ = 0;              ///< a time step that was seen to be stable [s]
    double stable_damping_ = 0;           ///< with that local damping [-]
    grains::Material stable_for_;         ///< of grains of this material
    std::int64_t stable_at_ = 0;          ///< number of the step at which it was
    bool steps_ = false, pauses_ = false; ///< a call steps it; and calls back just now
    mutable int readers_ = 0;             ///< calls that read it with the interpreter released
};

/// A world as measures are to see it: before its first step with the contacts that its geometry has now.
class SeenWorld {
public:
    explicit SeenWorld(const WorldHandle& handle) : SeenWorld(handle.world()) {}

    explicit SeenWorld(const dem::World& world);

    operator const dem::World&() const { return first_ ? *first_ : world_; } // NOLINT(google-explicit-constructor)

private:
    const dem::World& world_;
    std::optional<dem::World> first_;
};

/// A call that steps a world, and has it to itself. Made and ended with the interpreter held.
/// @throws StateError where another call steps or reads it, or there is nothing to step
class Stepping {
public:
    explicit Stepping(WorldHandle& handle);

    ~Stepping() { handle_.steps_ = false; }

    Stepping(const Stepping&) = delete;
    Stepping& operator=(const Stepping&) = delete;

    [[nodiscard]] dem::World& world() {
        handle_.follow_density();
        return handle_.world_;
    }

    /// For changes of the rows.
    dem::World& world_for_new_rows() { return handle_.part_from_views(); }

    /// @param damping local [-] @throws CaseError where the sample is unstable with a time step of the caller's [s]
    void check_time_step(double time_step, double damping);

    /// The step's caches, made afresh where motion or cell were changed by hand since the last step.
    dem::StepCaches& caches();

    /// After a change of masses: the caches hold copies of them.
    void drop_caches() { handle_.caches_ = {}; }

    /// After steps: what the caches belong to.
    void remember_place();

    /// Between two bursts, while the caller's function runs: the world may be read.
    class Pause {
    public:
        explicit Pause(Stepping& call) : handle_(call.handle_) { handle_.pauses_ = true; }

        ~Pause() { handle_.pauses_ = false; }

        Pause(const Pause&) = delete;
        Pause& operator=(const Pause&) = delete;

    private:
        WorldHandle& handle_;
    };

private:
    /// Whether Python moved grains or the cell since the last step.
    bool was_moved();

    WorldHandle& handle_;
};

/// A call that reads a world with the interpreter released: nobody steps it meanwhile. Made and ended with the
/// interpreter held. @throws StateError where another call steps it
class Reading {
public:
    explicit Reading(const WorldHandle& handle) : handle_(handle), world_(handle.world()) { ++handle_.readers_; }

    ~Reading() { --handle_.readers_; }

    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

    [[nodiscard]] const dem::World& world() const { return world_; }

private:
    const WorldHandle& handle_;
    const dem::World& world_;
};

/// The curve of a packing, with a step at each size of its grains. @throws CaseError where there are none
grains::Grading grading_of(const grains::Grains& grains);

/// The grain table as Python sees it.
struct GrainTable {
    std::shared_ptr<WorldHandle> handle;
};

/// Columns of the grain table as attributes; the one place that knows how a column is stored.
void bind_grain_columns(pybind11::class_<GrainTable>& type);

} // namespace suffuse::python
