#include "suffuse/pores/widest_path.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/pores/offset_union.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace suffuse::pores {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::int32_t component(const cell::Image& image, int axis) {
    return axis == 0 ? image.a : axis == 1 ? image.b : image.c;
}

/// Sets of pores joined so far. A set's loops lead through the cell by whole multiples of their greatest common
/// divisor: exactly one period is possible where that is 1.
class OpenPores {
public:
    OpenPores(std::size_t pores, int axis)
        : axis_(axis), sets_(pores), divisor_(pores, 0), last_(pores), next_(pores, none),
          diameter_(pores, -std::numeric_limits<double>::infinity()), is_through_(pores, 0) {
        std::iota(last_.begin(), last_.end(), std::uint32_t{0});
    }

    /// Opens a throat of this diameter between pore `p` and pore `q` moved by `image`.
    void open(std::uint32_t p, std::uint32_t q, const cell::Image& image, double diameter) {
        const OffsetUnion::Joined joined = sets_.join(p, q, image);
        const std::uint32_t kept = joined.kept, other = joined.absorbed;
        if (kept == other) {
            divisor_[kept] = std::gcd(divisor_[kept], component(joined.loop, axis_));
            if (divisor_[kept] == 1 && is_through_[kept] == 0) {
                reach(kept, diameter);
            }
            return;
        }
        divisor_[kept] = std::gcd(divisor_[kept], divisor_[other]);
        if (divisor_[kept] == 1) { // members of a set that was through already have their diameter
            if (is_through_[kept] == 0) {
                reach(kept, diameter);
            }
            if (is_through_[other] == 0) {
                reach(other, diameter);
            }
        }
        next_[last_[kept]] = other;
        last_[kept] = last_[other];
    }

    [[nodiscard]] std::vector<double> diameters() && { return std::move(diameter_); }

private:
    /// Gives all members of the set their diameter. A set's root is the first of its members.
    void reach(std::uint32_t root, double diameter) {
        is_through_[root] = 1;
        for (std::uint32_t p = root; p != none; p = next_[p]) {
            diameter_[p] = diameter;
        }
    }

    int axis_;
    OffsetUnion sets_;
    std::vector<std::int32_t> divisor_;      ///< by root
    std::vector<std::uint32_t> last_, next_; ///< members of a set as a list: last by root, next by member
    std::vector<double> diameter_;
    std::vector<std::uint8_t> is_through_; ///< by root
};

} // namespace

int axis_along(const Mat3& h, const Vec3& direction) {
    int best = 0;
    double largest = -1;
    for (int a = 0; a < 3; ++a) {
        const double alignment = std::abs(dot(h.column(a), direction)) / norm(h.column(a));
        if (alignment > largest) {
            largest = alignment, best = a;
        }
    }
    return best;
}

std::vector<double> widest_paths(const PoreNetwork& network, int axis) {
    expects(axis >= 0 && axis < 3, "a cell has the axes 0, 1 and 2");
    const Throats& throats = network.throats;
    std::vector<std::uint32_t> order(throats.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const double ra = throats.inscribed_radius[a], rb = throats.inscribed_radius[b];
        return ra > rb || (ra == rb && a < b);
    });
    OpenPores open(network.pores.size(), axis);
    for (const std::uint32_t t : order) {
        open.open(throats.side[t][0], throats.side[t][1], throats.image[t], 2 * throats.inscribed_radius[t]);
    }
    return std::move(open).diameters();
}

} // namespace suffuse::pores
