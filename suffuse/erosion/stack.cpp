#include "suffuse/erosion/stack.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/pores/widest_path.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::erosion {
namespace {

/// The middle of the fine grains on the circle of a period [m].
double middle_of_fines(const dem::World& world, const Vec3& along, double length) {
    double sine = 0, cosine = 0;
    for (std::size_t g = 0; g < world.grains.size(); ++g) {
        if (world.grains.fine[g] != 0) {
            const double angle = 2 * pi * dot(world.grains.position[g], along) / length;
            sine += world.grains.mass[g] * std::sin(angle);
            cosine += world.grains.mass[g] * std::cos(angle);
        }
    }
    return std::atan2(sine, cosine) / (2 * pi) * length;
}

/// Spheres along the flow: of one kind, by the distance of their centers from the middle of the base.
struct Row {
    double at = 0, radius = 0; ///< [m]
    bool is_base = false;
};

/// The plane at one side of the base, from its middle, beyond which there is as much of the base as there is of the
/// filter before it [m]. @param side 1: where the water leaves the base, -1: where it enters
double parting_plane(const std::vector<Row>& rows, double side, double half_length) {
    const auto excess = [&](double plane) { // of the base beyond it over the filter before it
        double base = 0, filter = 0;
        for (const Row& row : rows) {
            const double below = cap_volume(row.radius, plane - (side * row.at - row.radius));
            if (row.is_base) {
                base += sphere_volume(row.radius) - below;
            } else if (side * row.at > 0) {
                filter += below;
            }
        }
        return base - filter;
    };
    double low = 0, high = half_length;
    constexpr int halvings = 50;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (low + high);
        (excess(middle) > 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Fall of a head along the flow between two places, by least squares over the water there.
class Fall {
public:
    Fall(double from, double to) : from_(from), to_(to) {}

    void add(double at, double volume, double head) {
        if (at >= from_ && at <= to_) {
            const double x = at - from_;
            n_ += volume;
            x_ += volume * x;
            y_ += volume * head;
            xx_ += volume * x * x;
            xy_ += volume * x * head;
        }
    }

    [[nodiscard]] double per_length() const {
        const double spread = n_ * xx_ - x_ * x_;
        return spread > 0 ? -(n_ * xy_ - x_ * y_) / spread : 0;
    }

private:
    double from_, to_;
    double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

} // namespace

double moved_into(double at, double from, double length) {
    return at - std::floor((at - from) / length) * length;
}

double Stack::place(double at) const {
    return moved_into(at, 0.5 * (face + interface - length), length);
}

double cap_volume(double radius, double h) {
    const double inside = std::clamp(h, 0.0, 2 * radius);
    return pi * inside * inside * (radius - inside / 3);
}

Stack find_layers(const dem::World& world, const Vec3& direction) {
    const Vec3 along = direction / norm(direction);
    const grains::Grains& grains = world.grains;
    Stack stack;
    stack.length = std::abs(dot(world.cell.h.column(pores::axis_along(world.cell.h, direction)), along));
    const double middle = middle_of_fines(world, along, stack.length);
    std::vector<Row> rows;
    rows.reserve(grains.size());
    double base = 0, filter = 0;
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double r = grains.radius[g], at = dot(grains.position[g], along);
        const bool is_base = grains.fine[g] != 0;
        rows.push_back({moved_into(at, middle - 0.5 * stack.length, stack.length) - middle, r, is_base});
        (is_base ? base : filter) += sphere_volume(r);
        double& largest = is_base ? stack.base_grain : stack.filter_grain;
        largest = std::max(largest, 2 * r);
    }
    const double up = parting_plane(rows, -1, 0.5 * stack.length), down = parting_plane(rows, 1, 0.5 * stack.length);
    stack.face = middle - up;
    stack.interface = middle + down;
    constexpr double mixed = 0.25; // of the smaller of the two, as filter grains within the base: layers have less
    double before = 0;
    for (const Row& row : rows) {
        before += !row.is_base && row.at > -up && row.at < down ? sphere_volume(row.radius) : 0;
    }
    if (before > mixed * std::min(base, filter)) {
        throw StateError("the sample has no layers: coarse grains are everywhere along the flow, among the fine ones; "
                         "pack it with `layers`, and let the water go from the base into the filter");
    }
    return stack;
}

std::vector<std::uint8_t> held_in_stack(const dem::World& world, const Stack& stack, const Vec3& direction) {
    const Vec3 along = direction / norm(direction);
    std::vector<std::uint8_t> held(world.grains.size(), 1);
    for (std::size_t g = 0; g < held.size(); ++g) {
        const double from_face = stack.place(dot(world.grains.position[g], along)) - stack.face;
        held[g] = world.grains.fine[g] == 0 || from_face < stack.base_grain ? 1 : 0;
    }
    return held;
}

double share_at_interface(double at, double radius, const Stack& stack) {
    const double lowest = stack.place(at) - radius;
    const double from = stack.interface - 0.5 * stack.base_grain, to = stack.interface + stack.filter_grain;
    return (cap_volume(radius, to - lowest) - cap_volume(radius, from - lowest)) / sphere_volume(radius);
}

LayerHeads layer_heads(
    const flow::Seepage& seepage, const grains::Grains& grains, std::span<const Vec3> force, const Stack& stack,
    const Vec3& direction
) {
    const Vec3 along = direction / norm(direction);
    const pores::Pores& pores = seepage.network.pores;
    const double mean = norm(seepage.pressure_gradient); // of the sample [Pa/m]
    const double end = stack.face + stack.length;
    Fall base(stack.face + 0.5 * stack.base_grain, stack.interface - 0.5 * stack.base_grain);
    Fall filter(stack.interface + 0.5 * stack.filter_grain, end - 0.5 * stack.filter_grain);
    for (std::size_t p = 0; p < pores.size(); ++p) {
        const double there = dot(pores.center[p], along), at = moved_into(there, stack.face, stack.length);
        const double pressure = seepage.field.pressure[p] - (at - there) * mean; // falls by as much in a period
        const double volume = std::max(0.0, pores.void_volume[p]);
        base.add(at, volume, pressure);
        filter.add(at, volume, pressure);
    }
    double there = 0, all = 0; // [N]
    for (std::size_t g = 0; g < grains.size(); ++g) {
        const double push = dot(force[g], along);
        there += push * share_at_interface(dot(grains.position[g], along), grains.radius[g], stack);
        all += push;
    }
    return {base.per_length() / mean, filter.per_length() / mean, there / all};
}

} // namespace suffuse::erosion
