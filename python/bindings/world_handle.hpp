#pragma once
// A world as Python holds it, and NumPy arrays that look into it without copying. An array keeps alive what it looks
// into. Where rows are about to be added, removed or reordered while arrays look at them, those arrays keep the old
// rows, to themselves, and the world goes on with new ones: nobody ever looks at freed memory.

#include "suffuse/dem/step.hpp"

#include <memory>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <vector>

namespace suffuse::python {

class WorldHandle {
public:
    explicit WorldHandle(dem::World world) : world_(std::move(world)), density_(world_.material.density) {}

    WorldHandle(const WorldHandle&) = delete;
    WorldHandle& operator=(const WorldHandle&) = delete;

    [[nodiscard]] const dem::World& world() const {
        follow_density();
        return world_;
    }

    /// For changes that leave every column where it is.
    [[nodiscard]] dem::World& world() {
        follow_density();
        return world_;
    }

    /// For changes of the rows.
    dem::World& world_for_new_rows();

    /// The step's caches, made afresh where motion or cell were changed by hand since the last step.
    dem::StepCaches& caches();

    /// After a change of masses: the caches hold copies of them.
    void drop_caches() { caches_ = {}; }

    /// After steps: what the caches belong to.
    void remember_place();

    /// Kept alive by arrays, beside the handle itself: the rows that they look into once the world has moved on.
    [[nodiscard]] std::shared_ptr<const void> rows_of_views() const { return kept_; }

private:
    /// Python may set the density of the material that it was given to look at: the masses are then another density's.
    void follow_density() const;

    mutable dem::World world_;
    mutable dem::StepCaches caches_;
    mutable double density_;                ///< that masses and inertia are of [kg/m3]
    std::vector<Vec3> position_, velocity_; ///< after the last step
    Mat3 h_{};
    std::shared_ptr<grains::Grains> kept_ = std::make_shared<grains::Grains>();
};

/// The grain table as Python sees it.
struct GrainTable {
    std::shared_ptr<WorldHandle> handle;
};

/// Columns of the grain table as attributes; the one place that knows how a column is stored.
void bind_grain_columns(pybind11::class_<GrainTable>& type);

} // namespace suffuse::python
