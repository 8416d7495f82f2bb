#pragma once
// The contact table: the pairs that touch or nearly touch, and what they remember from the last step. Normal, overlap
// and force are made on demand by `inspect_contacts`; the step keeps only what the next step needs.

#include "suffuse/base/vec3.hpp"
#include "suffuse/cell/cell.hpp"

#include <cstdint>
#include <vector>

namespace suffuse::contact {

/// A column of vectors, stored by component so that a loop over contacts reads and writes it in unit stride.
struct VectorColumn {
    std::vector<double> x, y, z;

    [[nodiscard]] Vec3 operator[](std::size_t c) const { return {x[c], y[c], z[c]}; }

    void set(std::size_t c, const Vec3& v) { x[c] = v.x, y[c] = v.y, z[c] = v.z; }

    void resize(std::size_t rows) { x.resize(rows), y.resize(rows), z.resize(rows); }

    void push_back(const Vec3& v) { x.push_back(v.x), y.push_back(v.y), z.push_back(v.z); }

    void clear() { x.clear(), y.clear(), z.clear(); }

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

/// Rows are sorted by (first, second, image). A row whose memory `normal` is zero does not touch: it is a near neighbor
/// that the step watches, and its other memory is zero too.
struct Contacts {
    std::vector<std::uint32_t> first, second; ///< rows of the grain table
    std::vector<cell::Image> image;   ///< period of `second` as seen from `first`: x2 = position[second] + h image
    VectorColumn shear_force;         ///< acting on `second` (minus it on `first`) [N]
    VectorColumn bending;             ///< bending moment acting on `second` (minus it on `first`) [N m]
    VectorColumn normal;              ///< of the last step, from first to second [-]
    std::vector<double> overlap;      ///< of the last step, zero where the pair does not touch [m]
    VectorColumn twisting;            ///< twisting moment; empty unless the material has a twisting stiffness [N m]
    std::vector<std::uint8_t> bonded; ///< 1: adhesion not yet broken; empty unless some contact is bonded

    [[nodiscard]] std::size_t size() const { return first.size(); }

    [[nodiscard]] bool touches(std::size_t c) const { return normal.x[c] != 0 || normal.y[c] != 0 || normal.z[c] != 0; }
};

} // namespace suffuse::contact
