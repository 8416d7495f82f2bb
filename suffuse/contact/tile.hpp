#pragma once
// A tile: up to 64 contacts side by side, in rows that a loop without branches turns into vector instructions. Where
// the law's parts meet; used by the hot loop alone.

#include "suffuse/base/double4.hpp"
#include "suffuse/contact/linear_rolling.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace suffuse::contact {

inline constexpr std::size_t tile_rows = 64;

template <class Real>
using Row = std::array<Real, tile_rows>;

template <class Real>
struct alignas(64) Rows3 {
    Row<Real> x, y, z;
};

/// The two grains of each contact of a tile, side by side, and what the parts of the law leave to the next one. Where
/// the grains are is known in double precision, whatever the rest: an overlap is a small difference of large numbers.
template <class Real>
struct alignas(64) Tile {
    Rows3<double> branch;
    Rows3<Real> velocity, spin_1, spin_2;
    Row<double> exact_radius_1, exact_radius_2;
    Row<Real> radius_1, radius_2, bonded;
    Rows3<Real> normal;
    Row<Real> overlap, reach_over_distance, normal_stiffness;
    Rows3<Real> shear_force, bending, twisting;
    Row<Real> normal_force, slip_limit, bending_limit, twisting_limit, touching;

    // The motion is not needed any more when the contact's action on its grains is known.
    Rows3<Real>& force() { return velocity; }

    Rows3<Real>& torque_1() { return spin_1; }

    Rows3<Real>& torque_2() { return spin_2; }
};

template <class Real>
[[gnu::always_inline]] inline Triple<Real> triple(const Rows3<Real>& rows, std::size_t k) {
    return {rows.x[k], rows.y[k], rows.z[k]};
}

template <class Real, class Other>
[[gnu::always_inline]] inline void set(Rows3<Real>& rows, std::size_t k, const Triple<Other>& v) {
    rows.x[k] = static_cast<Real>(v.x), rows.y[k] = static_cast<Real>(v.y), rows.z[k] = static_cast<Real>(v.z);
}

template <class Real>
[[gnu::always_inline]] inline ContactGeometry<Real> geometry_at(const Tile<Real>& t, std::size_t k) {
    return {triple(t.normal, k), t.overlap[k], t.reach_over_distance[k], t.normal_stiffness[k]};
}

/// Four lanes, narrowed where the rows are of single precision.
[[gnu::always_inline]] inline void put(Row<double>& row, std::size_t k, const Double4& q) {
    std::memcpy(&row[k], &q, sizeof(q));
}

[[gnu::always_inline]] inline void put(Row<float>& row, std::size_t k, const Double4& q) {
    const Float4 narrow = narrowed(q);
    std::memcpy(&row[k], &narrow, sizeof(narrow));
}

[[gnu::always_inline]] inline Double4 get(const Row<double>& row, std::size_t k) {
    Double4 q;
    std::memcpy(&q, &row[k], sizeof(q));
    return q;
}

[[gnu::always_inline]] inline Double4 get(const Row<float>& row, std::size_t k) {
    Float4 q;
    std::memcpy(&q, &row[k], sizeof(q));
    return widened(q);
}

using Double4x4 = std::array<Double4, 4>;

template <class Real>
[[gnu::always_inline]] inline void put(Rows3<Real>& rows, std::size_t k, const Double4x4& t) {
    put(rows.x, k, t[0]);
    put(rows.y, k, t[1]);
    put(rows.z, k, t[2]);
}

template <class Real>
[[gnu::always_inline]] inline Double4x4 vectors(const Rows3<Real>& rows, std::size_t k) {
    return transposed(get(rows.x, k), get(rows.y, k), get(rows.z, k), Double4{});
}

} // namespace suffuse::contact
