#pragma once
// Four doubles side by side: one register of AVX, half of one of AVX-512, two of plain x86-64. The compiler's vector
// extension supplies + - * / and comparisons lane by lane, with the bits of plain doubles.

#include "suffuse/base/vec3.hpp"

#include <array>

namespace suffuse {

using Quad = double __attribute__((vector_size(32)));

/// Four floats side by side, for what need not be known to the last bit.
using FloatQuad = float __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Quad widened(const FloatQuad& q) {
    return Quad{q[0], q[1], q[2], q[3]}; // one instruction; the compiler's conversion of vectors makes five of it
}

[[gnu::always_inline]] inline FloatQuad narrowed(const Quad& q) {
    return __builtin_convertvector(q, FloatQuad);
}

[[gnu::always_inline]] inline Quad quad(const Vec3& v, double last) {
    return Quad{v.x, v.y, v.z, last};
}

[[gnu::always_inline]] inline Vec3 xyz(const Quad& q) {
    return {q[0], q[1], q[2]};
}

/// x, y and z of `xyz`, the last lane of `last`.
[[gnu::always_inline]] inline Quad with_last_of(const Quad& xyz, const Quad& last) {
    return __builtin_shufflevector(xyz, last, 0, 1, 2, 7);
}

template <int Lane>
[[gnu::always_inline]] inline Quad broadcast(const Quad& q) {
    return __builtin_shufflevector(q, q, Lane, Lane, Lane, Lane);
}

/// Four rows become four columns.
[[gnu::always_inline]] inline std::array<Quad, 4>
transposed(const Quad& a, const Quad& b, const Quad& c, const Quad& d) {
    const Quad ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Quad cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return {
        __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5), __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5),
        __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7), __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7)};
}

/// A 3 x 3 matrix by columns; its product with the x, y and z of a quad has the bits of Mat3 times Vec3.
struct QuadMatrix {
    std::array<Quad, 3> column;
};

inline QuadMatrix quad_matrix(const Mat3& m) {
    return {{quad(m.column(0), 0), quad(m.column(1), 0), quad(m.column(2), 0)}};
}

[[gnu::always_inline]] inline Quad operator*(const QuadMatrix& m, const Quad& v) {
    return m.column[0] * broadcast<0>(v) + m.column[1] * broadcast<1>(v) + m.column[2] * broadcast<2>(v);
}

/// The diagonal of a matrix: times a quad, lane by lane, it does what a diagonal QuadMatrix does with fewer operations.
inline Quad quad_diagonal(const Mat3& m) {
    return Quad{m(0, 0), m(1, 1), m(2, 2), 0};
}

} // namespace suffuse
