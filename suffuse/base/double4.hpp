#pragma once
// Four doubles side by side: one register of AVX, half of one of AVX-512, two of plain x86-64. The compiler's vector
// extension supplies + - * / and comparisons lane by lane, with the bits of plain doubles.

#include "suffuse/base/vec3.hpp"

#include <array>
#include <cstddef>

namespace suffuse {

using Double4 = double __attribute__((vector_size(32)));

/// Of everything that holds one: code for plain processors would do with less, code for AVX would not.
inline constexpr std::size_t double4_alignment = 32;

/// Four floats side by side, for what need not be known to the last bit.
using Float4 = float __attribute__((vector_size(16)));

[[gnu::always_inline]] inline Double4 widened(const Float4& q) {
    return Double4{q[0], q[1], q[2], q[3]}; // one instruction; the compiler's conversion of vectors makes five of it
}

[[gnu::always_inline]] inline Float4 narrowed(const Double4& q) {
    return __builtin_convertvector(q, Float4);
}

[[gnu::always_inline]] inline Double4 double4(const Vec3& v, double last) {
    return Double4{v.x, v.y, v.z, last};
}

[[gnu::always_inline]] inline Vec3 xyz(const Double4& q) {
    return {q[0], q[1], q[2]};
}

/// x, y and z of `xyz`, the last lane of `last`.
[[gnu::always_inline]] inline Double4 with_last_of(const Double4& xyz, const Double4& last) {
    return __builtin_shufflevector(xyz, last, 0, 1, 2, 7);
}

template <int Lane>
[[gnu::always_inline]] inline Double4 broadcast(const Double4& q) {
    return __builtin_shufflevector(q, q, Lane, Lane, Lane, Lane);
}

/// Four rows become four columns.
[[gnu::always_inline]] inline std::array<Double4, 4>
transposed(const Double4& a, const Double4& b, const Double4& c, const Double4& d) {
    const Double4 ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Double4 cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return {
        __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5), __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5),
        __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7), __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7)};
}

/// A 3 x 3 matrix by columns; its product with the x, y and z of a Double4 has the bits of Mat3 times Vec3.
struct alignas(double4_alignment) Double4x3 {
    std::array<Double4, 3> column;
};

inline Double4x3 double4x3(const Mat3& m) {
    return {{double4(m.column(0), 0), double4(m.column(1), 0), double4(m.column(2), 0)}};
}

[[gnu::always_inline]] inline Double4 operator*(const Double4x3& m, const Double4& v) {
    return m.column[0] * broadcast<0>(v) + m.column[1] * broadcast<1>(v) + m.column[2] * broadcast<2>(v);
}

/// The diagonal of a matrix: times a Double4, lane by lane, it does what a diagonal Double4x3 does with fewer
/// operations.
inline Double4 double4_diagonal(const Mat3& m) {
    return Double4{m(0, 0), m(1, 1), m(2, 2), 0};
}

} // namespace suffuse
