// Who may look at a world, and when.

#include "python/bindings/world_handle.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/dem/first_contacts.hpp"
#include "suffuse/dem/stable_dt.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <utility>

namespace suffuse::python {
namespace {

/// Materials are numbers, and nothing else.
bool are_alike(const grains::Material& a, const grains::Material& b) {
    using Numbers = std::array<double, sizeof(grains::Material) / sizeof(double)>;
    return std::bit_cast<Numbers>(a) == std::bit_cast<Numbers>(b);
}

} // namespace

void WorldHandle::follow_density() const {
    const double density = world_.material.density;
    if (density == density_) {
        return;
    }
    if (!(density > 0)) {
        world_.material.density = density_;
        throw CaseError(fmt::format("density: found {} kg/m3, expected a positive one", density));
    }
    for (std::size_t g = 0; g < world_.grains.size(); ++g) {
        world_.grains.mass[g] *= density / density_;
        world_.grains.inertia[g] *= density / density_;
    }
    caches_ = {};
    density_ = density;
}

const dem::World& WorldHandle::world() const {
    refuse_unless_open();
    follow_density();
    return world_;
}

dem::World& WorldHandle::world() {
    refuse_unless_open();
    follow_density();
    return world_;
}

dem::World& WorldHandle::world_for_new_rows() {
    if (steps_ || readers_ > 0) {
        refuse();
    }
    return part_from_views();
}

void WorldHandle::refuse() {
    throw StateError(
        "this world is in use by another call, which steps or reads it: wait until that has returned, look at the "
        "world in its on_progress, or work on a copy() made before"
    );
}

void WorldHandle::refuse_unless_open() const {
    if (!is_open()) {
        refuse();
    }
}

dem::World& WorldHandle::part_from_views() {
    follow_density();
    if (kept_.use_count() > 1) { // arrays look at these rows: the rows are theirs now
        grains::Grains copy = world_.grains;
        *kept_ = std::exchange(world_.grains, std::move(copy));
        kept_ = std::make_shared<grains::Grains>();
    }
    caches_ = {};
    position_.clear();
    return world_;
}

SeenWorld::SeenWorld(const dem::World& world) : world_(world) {
    if (dem::awaits_first_step(world_)) {
        dem::add_first_contacts(first_.emplace(world_));
    }
}

Stepping::Stepping(WorldHandle& handle) : handle_(handle) {
    if (handle.steps_ || handle.readers_ > 0) {
        WorldHandle::refuse();
    }
    if (handle.world_.grains.size() == 0) {
        throw StateError("this world has no grains: there is nothing to step");
    }
    handle.steps_ = true;
}

bool Stepping::was_moved() {
    const dem::World& now = world();
    return handle_.position_ != now.grains.position || !(handle_.h_ == now.cell.h);
}

void Stepping::check_time_step(double time_step, double damping) {
    // What the check costs is some tens of steps: many calls of a few steps make it as seldom as the steps need it.
    const std::int64_t since = world().clock.step - handle_.stable_at_;
    const bool is_fresh = since >= 0 && since < dem::time_step_interval && !was_moved() &&
                          are_alike(handle_.stable_for_, world().material);
    if (is_fresh && time_step <= handle_.stable_step_ && damping <= handle_.stable_damping_) {
        return;
    }
    dem::check_time_step(world(), time_step, damping);
    handle_.stable_step_ = time_step;
    handle_.stable_damping_ = damping;
    handle_.stable_for_ = world().material;
    handle_.stable_at_ = world().clock.step;
}

dem::StepCaches& Stepping::caches() {
    if (was_moved() || handle_.velocity_ != world().grains.velocity) {
        handle_.caches_ = {};
    }
    return handle_.caches_;
}

void Stepping::remember_place() {
    handle_.position_ = handle_.world_.grains.position;
    handle_.velocity_ = handle_.world_.grains.velocity;
    handle_.h_ = handle_.world_.cell.h;
}

} // namespace suffuse::python
