#pragma once
// The contact table: the pairs that touch or nearly touch, and what they remember from the last step. Normal, overlap
// and force are made on demand by `inspect_contacts`; the step keeps only what the next step needs.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::contact {

/// A column of vectors, stored by component so that a loop over contacts reads and writes it in unit stride.
template <class Real>
struct VectorColumnOf {
    std::vector<Real> x, y, z;

    [[nodiscard]] Vec3 operator[](std::size_t c) const { return {x[c], y[c], z[c]}; }

    void set(std::size_t c, const Vec3& v) { x[c] = v.x, y[c] = v.y, z[c] = v.z; }

    void resize(std::size_t rows) { x.resize(rows), y.resize(rows), z.resize(rows); }

    void push_back(const Vec3& v) { x.push_back(v.x), y.push_back(v.y), z.push_back(v.z); }

    void clear() { x.clear(), y.clear(), z.clear(); }

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

using VectorColumn = VectorColumnOf<double>;

/// What contacts remember from the last step. The memory of a contact whose `normal` is zero is zero too: it does not
/// touch.
template <class Real>
struct MemoryOf {
    VectorColumnOf<Real> shear_force; ///< acting on `second` (minus it on `first`) [N]
    VectorColumnOf<Real> bending;     ///< bending moment acting on `second` (minus it on `first`) [N m]
    VectorColumnOf<Real> normal;      ///< of the last step, from first to second [-]
    std::vector<Real> overlap;        ///< of the last step, zero where the pair does not touch [m]
    VectorColumnOf<Real> twisting;    ///< twisting moment; empty unless the material has a twisting stiffness [N m]
    std::vector<std::uint8_t> bonded; ///< 1: adhesion not yet broken; empty unless some contact is bonded

    [[nodiscard]] bool touches(std::size_t c) const { return normal.x[c] != 0 || normal.y[c] != 0 || normal.z[c] != 0; }
};

/// In fast mode, during a burst of steps.
using SingleMemory = MemoryOf<float>;

/// Sorted by (first, second, image).
struct ContactPairs {
    std::vector<std::uint32_t> first, second; ///< rows of the grain table
    std::vector<cell::Image> image; ///< period of `second` as seen from `first`: x2 = position[second] + h image

    [[nodiscard]] std::size_t size() const { return first.size(); }
};

/// Pairs that do not touch are near neighbors that the step watches.
struct Contacts : ContactPairs, MemoryOf<double> {};

} // namespace suffuse::contact
