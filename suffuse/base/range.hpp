#pragma once
// From the least to the most of something that is not known yet.

#include <algorithm>
#include <cmath>

namespace suffuse {

struct Range {
    double least = 0, most = 0;

    Range& operator+=(const Range& other) { return least += other.least, most += other.most, *this; }
};

inline Range operator+(Range a, const Range& b) {
    return a += b;
}

inline Range operator*(double factor, const Range& r) {
    return {factor * r.least, factor * r.most};
}

inline Range operator*(const Range& a, const Range& b) {
    return {a.least * b.least, a.most * b.most};
}

/// The value that is as many times the least as the most is times it; `floor` stands for what is smaller.
inline double middle(const Range& range, double floor = 0) {
    return std::sqrt(std::max(range.least, floor) * std::max(range.most, floor));
}

} // namespace suffuse
