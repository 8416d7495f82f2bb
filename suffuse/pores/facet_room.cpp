#include "suffuse/pores/facet_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::pores {
namespace {

/// Reach into a grain that is rounding, over the longest edge of the facet.
constexpr double rounding = 1e-13;

constexpr std::size_t most_grains = 3 + NearGrains::most;

struct Point {
    double x, y;
};

constexpr Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
}

constexpr double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y;
}

constexpr double cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}

/// A grain as the plane of the facet sees it.
struct Seen {
    Point at;       ///< foot of its center
    double height2; ///< of its center above the plane, squared
    double r;
};

double clearance(const Seen& grain, const Point& p) {
    return std::sqrt(dot(p - grain.at, p - grain.at) + grain.height2) - grain.r;
}

/// Clearance is convex around each grain, so that the least of several is largest where three balance each other or,
/// along an edge, two: each such point is examined.
class FacetRoom {
public:
    FacetRoom(const Point& b, const Point& c, const std::array<double, 3>& r) : corner_{{{0, 0}, b, c}} {
        for (std::size_t k = 0; k < 3; ++k) {
            const Point to = corner_[(k + 1) % 3] - corner_[k];
            const double length = std::sqrt(dot(to, to));
            const double half_gap = 0.5 * (length - r[k] - r[(k + 1) % 3]);
            edge_[k] = {corner_[k], {to.x / length, to.y / length}, length, half_gap, k, (k + 1) % 3};
            longest_ = std::max(longest_, length);
            grain_[size_++] = {corner_[k], 0, r[k]};
        }
    }

    void add(const Seen& grain) { grain_[size_++] = grain; }

    /// The three grains alone balance where their circle is, which is not free. Those that were added last mostly bound
    /// the room, and what has less is passed over: they come first.
    void search() {
        value_ = -std::numeric_limits<double>::infinity();
        for (std::size_t k = size_; k-- > 3;) {
            for (std::size_t j = k; j-- > 1;) {
                for (std::size_t i = j; i-- > 0;) {
                    balance(grain_[i], grain_[j], grain_[k]);
                }
            }
        }
        for (const Edge& edge : edge_) {
            search_edge(edge);
        }
        for (std::size_t k = 0; value_ < 0 && k < 3; ++k) { // grains fill the triangle
            measure(corner_[k]);
        }
    }

    [[nodiscard]] double value() const { return value_; }

    [[nodiscard]] const Point& place() const { return place_; }

private:
    struct Edge {
        Point from, along;
        double length;
        double half_gap; ///< between the grains at its ends: no sphere on it is larger
        std::size_t first, last;
    };

    void measure(const Point& p) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < size_; ++k) {
            least = std::min(least, clearance(grain_[k], p));
        }
        if (least > value_) {
            value_ = least, place_ = p;
        }
    }

    /// Sizes t with |u + t v|^2 + height^2 = (t + r)^2, where p = r - u v and q = u^2 + height^2 - r^2: where grains
    /// balance no more room is left than t.
    template <class Act>
    void solve(double p, double q, double v2, const Act& act) const {
        const double discriminant = p * p + (1 - v2) * q;
        if (!(discriminant >= 0)) {
            return;
        }
        const double root = std::sqrt(discriminant);
        for (const double divisor : {p + root, p - root}) {
            const double t = q / divisor;
            if (t > value_ && std::isfinite(t)) {
                act(t);
            }
        }
    }

    [[nodiscard]] bool holds(const Point& p) const {
        return std::all_of(edge_.begin(), edge_.end(), [&](const Edge& edge) {
            return cross(edge.along, p - edge.from) >= -rounding * longest_;
        });
    }

    void balance(const Seen& i, const Seen& j, const Seen& k) {
        const Point to_j = j.at - i.at, to_k = k.at - i.at;
        const auto middle = [&](const Seen& other, const Point& to) {
            return 0.5 * (dot(to, to) + other.height2 - i.height2 + i.r * i.r - other.r * other.r);
        };
        const double inverse = 1 / cross(to_j, to_k);
        const auto in_plane = [&](double along_j, double along_k) {
            return Point{
                (along_j * to_k.y - along_k * to_j.y) * inverse, (along_k * to_j.x - along_j * to_k.x) * inverse};
        };
        const Point u = in_plane(middle(j, to_j), middle(k, to_k)), v = in_plane(i.r - j.r, i.r - k.r);
        solve(i.r - dot(u, v), dot(u, u) + i.height2 - i.r * i.r, dot(v, v), [&](double t) {
            const Point at = {i.at.x + u.x + t * v.x, i.at.y + u.y + t * v.y};
            if (holds(at)) {
                measure(at);
            }
        });
    }

    void search_edge(const Edge& edge) {
        if (!(edge.half_gap > value_)) {
            return;
        }
        const Seen &first = grain_[edge.first], &last = grain_[edge.last];
        const auto measure_at = [&](double s) { // from the first end
            if (s >= 0 && s <= edge.length) {
                measure({edge.from.x + s * edge.along.x, edge.from.y + s * edge.along.y});
            }
        };
        measure_at(first.r + edge.half_gap);
        std::array<Point, most_grains> others{}; // where along the edge, and how far from it, squared
        std::array<double, most_grains> r{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            if (k == edge.first || k == edge.last) {
                continue;
            }
            const Point from = grain_[k].at - edge.from;
            const double off_edge = cross(edge.along, from);
            others[count] = {dot(edge.along, from), off_edge * off_edge + grain_[k].height2};
            r[count++] = grain_[k].r;
        }
        // Of a grain in the end, clearance is linear along the edge: s - r.
        const auto balance_with_end = [&](double place, double across2, double own, double r_end) {
            const double more = own - r_end;
            return (place * place + across2 - more * more) / (2 * (place + more));
        };
        for (std::size_t k = 0; k < count; ++k) {
            const Point& at = others[k];
            const double s = balance_with_end(at.x, at.y, r[k], first.r);
            if (s - first.r > value_) {
                measure_at(s);
            }
            const double back = balance_with_end(edge.length - at.x, at.y, r[k], last.r);
            if (back - last.r > value_) {
                measure_at(edge.length - back);
            }
            for (std::size_t j = 0; j < k; ++j) {
                const double apart = at.x - others[j].x, rj = r[j];
                const double u = 0.5 * (apart + (at.y - others[j].y + rj * rj - r[k] * r[k]) / apart);
                const double v = (rj - r[k]) / apart;
                solve(rj - u * v, u * u + others[j].y - rj * rj, v * v, [&](double t) {
                    measure_at(others[j].x + u + t * v);
                });
            }
        }
    }

    std::array<Point, 3> corner_;
    std::array<Edge, 3> edge_{};
    double longest_ = 0;
    std::array<Seen, most_grains> grain_{};
    std::size_t size_ = 0;
    double value_ = 0;
    Point place_{};
};

} // namespace

InscribedCircle largest_in_facet(
    const Vec3& b, const Vec3& c, const std::array<double, 3>& r, const InscribedCircle& circle, const NearGrains& near
) {
    const Vec3 across = cross(b, c);
    const double long_b = norm(b);
    const Vec3 ex = b / long_b, ez = across / norm(across), ey = cross(ez, ex);
    FacetRoom room({long_b, 0}, {dot(c, ex), dot(c, ey)}, r);
    InscribedCircle found = circle;
    std::array<bool, NearGrains::most> is_in{};
    const auto add_what_reaches_in = [&] {
        bool any = false;
        for (std::size_t k = 0; k < near.size; ++k) {
            if (!is_in[k] && reaches_in(near, k, found)) {
                const double height = dot(near.center[k], ez);
                room.add({{dot(near.center[k], ex), dot(near.center[k], ey)}, height * height, near.radius[k]});
                is_in[k] = any = true;
            }
        }
        return any;
    };
    if (circle.is_inside) {
        add_what_reaches_in();
    }
    do {
        room.search();
        found = {room.place().x * ex + room.place().y * ey, room.value(), true};
    } while (add_what_reaches_in());
    return found;
}

} // namespace suffuse::pores
