#pragma once
// Vectors and matrices of the three directions of space.

#include <array>
#include <cmath>

namespace suffuse {

struct Vec3 {
    double x = 0, y = 0, z = 0;

    constexpr double& operator[](int a) { return a == 0 ? x : a == 1 ? y : z; }

    constexpr double operator[](int a) const { return a == 0 ? x : a == 1 ? y : z; }

    constexpr Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }

    constexpr Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }

    constexpr Vec3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }

    constexpr bool operator==(const Vec3&) const = default;
};

constexpr Vec3 operator+(Vec3 a, const Vec3& b) {
    return a += b;
}

constexpr Vec3 operator-(Vec3 a, const Vec3& b) {
    return a -= b;
}

constexpr Vec3 operator-(const Vec3& a) {
    return {-a.x, -a.y, -a.z};
}

constexpr Vec3 operator*(double s, Vec3 a) {
    return a *= s;
}

constexpr Vec3 operator*(Vec3 a, double s) {
    return a *= s;
}

constexpr Vec3 operator/(const Vec3& a, double s) {
    return {a.x / s, a.y / s, a.z / s};
}

constexpr double dot(const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

constexpr double norm2(const Vec3& a) {
    return dot(a, a);
}

inline double norm(const Vec3& a) {
    return std::sqrt(norm2(a));
}

/// `a`, or a vector along it of length near 1 where its square would leave the numbers that there are.
inline Vec3 squarable(const Vec3& a) {
    const double largest = std::fmax(std::abs(a.x), std::fmax(std::abs(a.y), std::abs(a.z)));
    const bool is_far = largest > 1e100 || (largest > 0 && largest < 1e-100);
    return is_far && std::isfinite(largest) ? a / largest : a;
}

/// A 3 x 3 matrix, `m[row][column]`.
struct Mat3 {
    std::array<std::array<double, 3>, 3> m{};

    constexpr std::array<double, 3>& operator[](int a) { return m[static_cast<std::size_t>(a)]; }

    constexpr const std::array<double, 3>& operator[](int a) const { return m[static_cast<std::size_t>(a)]; }

    [[nodiscard]] constexpr double operator()(int a, int b) const {
        return m[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    }

    constexpr double& operator()(int a, int b) { return m[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]; }

    [[nodiscard]] constexpr Vec3 column(int b) const { return {(*this)(0, b), (*this)(1, b), (*this)(2, b)}; }

    [[nodiscard]] constexpr Vec3 row(int a) const { return {(*this)(a, 0), (*this)(a, 1), (*this)(a, 2)}; }

    constexpr bool operator==(const Mat3&) const = default;

    constexpr Mat3& operator+=(const Mat3& o) {
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                (*this)(a, b) += o(a, b);
            }
        }
        return *this;
    }
};

constexpr Mat3 diagonal(const Vec3& d) {
    return {{{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}}};
}

constexpr Mat3 identity() {
    return diagonal({1, 1, 1});
}

constexpr Mat3 from_columns(const Vec3& a, const Vec3& b, const Vec3& c) {
    return {{{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}}}};
}

constexpr Mat3 operator*(double s, Mat3 a) {
    for (auto& row : a.m) {
        for (double& v : row) {
            v *= s;
        }
    }
    return a;
}

constexpr Mat3 operator+(Mat3 a, const Mat3& b) {
    return a += b;
}

constexpr Mat3 operator-(const Mat3& a, const Mat3& b) {
    return a + (-1.0 * b);
}

constexpr Vec3 operator*(const Mat3& a, const Vec3& v) {
    return {dot(a.row(0), v), dot(a.row(1), v), dot(a.row(2), v)};
}

constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
    return from_columns(a * b.column(0), a * b.column(1), a * b.column(2));
}

constexpr Mat3 transpose(const Mat3& a) {
    return from_columns(a.row(0), a.row(1), a.row(2));
}

constexpr double trace(const Mat3& a) {
    return a(0, 0) + a(1, 1) + a(2, 2);
}

constexpr bool is_diagonal(const Mat3& a) {
    return a(0, 1) == 0 && a(0, 2) == 0 && a(1, 0) == 0 && a(1, 2) == 0 && a(2, 0) == 0 && a(2, 1) == 0;
}

constexpr double determinant(const Mat3& a) {
    return dot(a.column(0), cross(a.column(1), a.column(2)));
}

constexpr Mat3 outer(const Vec3& a, const Vec3& b) {
    return {
        {{{a.x * b.x, a.x * b.y, a.x * b.z}, {a.y * b.x, a.y * b.y, a.y * b.z}, {a.z * b.x, a.z * b.y, a.z * b.z}}}};
}

/// Inverse of a matrix that is not singular.
constexpr Mat3 inverse(const Mat3& a) {
    const Vec3 u = cross(a.column(1), a.column(2));
    const Vec3 v = cross(a.column(2), a.column(0));
    const Vec3 w = cross(a.column(0), a.column(1));
    return (1.0 / dot(a.column(0), u)) * transpose(from_columns(u, v, w));
}

} // namespace suffuse
