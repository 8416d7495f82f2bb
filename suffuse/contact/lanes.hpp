#pragma once
// The arithmetic of the laws, which are templates over the precision.

#include <cmath>

namespace suffuse::contact {

/// A vector of lanes.
template <class Real>
struct Triple {
    Real x{}, y{}, z{};
};

template <class Real>
constexpr Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Real>
constexpr Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
constexpr Triple<Real> operator*(const Real& s, const Triple<Real>& a) {
    return {s * a.x, s * a.y, s * a.z};
}

template <class Real>
constexpr Real dot(const Triple<Real>& a, const Triple<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Real>
inline Real root(Real a) {
    return std::sqrt(a);
}

template <class Real>
inline Real magnitude(Real a) {
    return std::abs(a);
}

} // namespace suffuse::contact
