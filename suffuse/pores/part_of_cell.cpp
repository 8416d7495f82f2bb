#include "suffuse/pores/part_of_cell.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/pores/power_center.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace suffuse::pores {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<
    std::uint32_t, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Point = Regular::Weighted_point;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The bits of a number of 16 bits, each three places above the one before.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 16) & 0xff0000ff;
    bits = (bits | bits << 8) & 0xf00f00f00f;
    bits = (bits | bits << 4) & 0xc30c30c30c3;
    bits = (bits | bits << 2) & 0x249249249249;
    return bits;
}

/// Place along a curve that visits the eighths of a cube one after the other, and so on within each (Morton).
std::uint64_t place_on_curve(const Vec3& s) {
    constexpr int bits = 16;
    std::uint64_t place = 0;
    for (int a = 0; a < 3; ++a) {
        place |= spread(static_cast<std::uint64_t>(std::ldexp(std::clamp(s[a], 0.0, 1 - 1e-9), bits))) << a;
    }
    return place;
}

std::int32_t floor(double x) {
    return static_cast<std::int32_t>(std::floor(x));
}

/// Rounding must not let two images of a tetrahedron differ, nor two parts that both see it: so near to a limit it is
/// decided on coordinates that are the same for both.
constexpr double near = 1e-9; // fractional coordinates

bool is_near_whole(double x) {
    return std::abs(x - std::nearbyint(x)) < near;
}

class GhostTriangulation {
public:
    GhostTriangulation(const ExactPacking& packing, const Cuts& cuts, const Part& part, Care care)
        : packing_(packing), cuts_(cuts), part_(part), care_(care),
          smallest_(*std::min_element(packing.radius.begin(), packing.radius.end())) {
        for (std::size_t a = 0; a < 3; ++a) {
            low_[a] = static_cast<double>(part[a]) / cuts[a];
            high_[a] = static_cast<double>(part[a] + 1) / cuts[a];
        }
    }

    /// Adds images around the part until no image that is left out can be in conflict with a tetrahedron that is kept,
    /// or, with care, with one that may touch the part.
    void cover() {
        double reach = initial_reach * packing_.spacing;
        insert_images(reach);
        for (int round = 0; round < 60; ++round) {
            const double needed = keep_tetrahedra();
            if (needed <= reach_) {
                return;
            }
            // Beyond a reach that is much too small the tetrahedra are those of the hull: they say nothing of the need.
            reach = std::min(1.02 * needed, 1.5 * reach_);
            insert_images(reach);
        }
        throw GeometryError(fmt::format(
            "pores: images within {} m of the cell are not enough to triangulate {} grains; are they all at one place?",
            reach_ * packing_.unit, packing_.radius.size()
        ));
    }

    [[nodiscard]] PartTetrahedra extract() const {
        PartTetrahedra out;
        out.points = points_.size();
        out.reach = reach_;
        out.corner.reserve(kept_.size()), out.neighbor.reserve(kept_.size()), out.place.reserve(kept_.size());
        for (const Regular::Cell_handle t : kept_) {
            const std::array<int, 4> order = rising_order(t);
            std::array<Corner, 4>& corner = out.corner.emplace_back();
            std::array<std::uint32_t, 4>& neighbor = out.neighbor.emplace_back();
            for (std::size_t k = 0; k < 4; ++k) {
                corner[k] = points_[t->vertex(order[k])->info()];
                neighbor[k] = t->neighbor(order[k])->info();
            }
            out.place.push_back(place_on_curve(decisive_centroid(t)));
        }
        return out;
    }

private:
    static constexpr double initial_reach = 1.1; ///< in spacings: enough for most packings of sand

    [[nodiscard]] std::array<Corner, 4> corners(Regular::Cell_handle t) const {
        return {
            points_[t->vertex(0)->info()], points_[t->vertex(1)->info()], points_[t->vertex(2)->info()],
            points_[t->vertex(3)->info()]};
    }

    /// The corners in rising order, the last two swapped where that makes the tetrahedron positive as CGAL's are.
    [[nodiscard]] std::array<int, 4> rising_order(Regular::Cell_handle t) const {
        const std::array<Corner, 4> given = corners(t);
        std::array<int, 4> order = {0, 1, 2, 3};
        bool is_even = true;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j + 1 < 4 - i; ++j) {
                if (given[static_cast<std::size_t>(order[j + 1])] < given[static_cast<std::size_t>(order[j])]) {
                    std::swap(order[j], order[j + 1]);
                    is_even = !is_even;
                }
            }
        }
        if (!is_even) {
            std::swap(order[2], order[3]);
        }
        return order;
    }

    [[nodiscard]] static Vec3 centroid(Regular::Cell_handle t) {
        Vec3 sum;
        for (int k = 0; k < 4; ++k) {
            const Point& x = t->vertex(k)->point();
            sum += Vec3{x.x(), x.y(), x.z()};
        }
        return 0.25 * sum;
    }

    [[nodiscard]] Vec3 place(const Corner& c) const {
        return packing_.position[c.grain] + shift(packing_.h, c.image); // exact
    }

    /// Fractional coordinates of the centroid of corners in the order given.
    [[nodiscard]] Vec3 fractional_centroid(const std::array<Corner, 4>& c) const {
        return 0.25 * (packing_.inverse_h * (place(c[0]) + place(c[1]) + place(c[2]) + place(c[3])));
    }

    /// The same for a tetrahedron of every triangulation that has it.
    [[nodiscard]] Vec3 decisive_centroid(Regular::Cell_handle t) const {
        std::array<Corner, 4> c = corners(t);
        std::sort(c.begin(), c.end());
        return fractional_centroid(c);
    }

    /// Whether the centroid of a tetrahedron lies in the cell and there in the part.
    [[nodiscard]] bool is_ours(Regular::Cell_handle t) const {
        const Vec3 s = packing_.inverse_h * centroid(t);
        if (std::min({s.x, s.y, s.z}) <= -near || std::max({s.x, s.y, s.z}) >= 1 + near) {
            return false;
        }
        if (std::min({s.x, s.y, s.z}) < near || std::max({s.x, s.y, s.z}) > 1 - near) {
            const Canonical<4> c = canonical(corners(t)); // the same for all images
            const Vec3 decisive = fractional_centroid(c.corners);
            if (c.moved + cell::Image{floor(decisive.x), floor(decisive.y), floor(decisive.z)} != cell::Image{}) {
                return false;
            }
        }
        std::optional<Vec3> decisive;
        for (int a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            if (cuts_[k] == 1) {
                continue;
            }
            double place = s[a] * cuts_[k];
            if (is_near_whole(place)) {
                decisive = decisive ? decisive : decisive_centroid(t);
                place = (*decisive)[a] * cuts_[k];
            }
            if (std::clamp(floor(place), 0, cuts_[k] - 1) != part_[k]) {
                return false;
            }
        }
        return true;
    }

    /// Whether a tetrahedron may have a point in the part.
    [[nodiscard]] bool may_touch(Regular::Cell_handle t) const {
        Vec3 least{unlimited, unlimited, unlimited}, most = -least;
        for (const Corner& c : corners(t)) {
            const Vec3 s = packing_.inverse_h * place(c);
            for (int a = 0; a < 3; ++a) {
                least[a] = std::min(least[a], s[a]), most[a] = std::max(most[a], s[a]);
            }
        }
        for (int a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            if (most[a] < low_[k] - near || least[a] > high_[k] + near) {
                return false;
            }
        }
        return true;
    }

    /// Whole periods n for which a surface of radius r at fractional coordinate s + n is within `reach` of the part.
    struct Range {
        std::int32_t first, last;

        [[nodiscard]] bool has(std::int32_t n) const { return first <= n && n <= last; }
    };

    [[nodiscard]] Range images_within(double reach, std::size_t g, std::size_t axis, double s) const {
        const double m = (reach + packing_.radius[g]) / packing_.width[static_cast<int>(axis)];
        return {-floor(s + m - low_[axis]), floor(high_[axis] + m - s)};
    }

    /// Inserts the images within `reach` that are not there yet.
    void insert_images(double reach) {
        std::vector<std::pair<Point, std::uint32_t>> fresh;
        for (std::uint32_t g = 0; g < packing_.radius.size(); ++g) {
            const Vec3& x = packing_.position[g];
            const Vec3 s = packing_.inverse_h * x;
            std::array<Range, 3> now{}, before{};
            for (std::size_t a = 0; a < 3; ++a) {
                now[a] = images_within(reach, g, a, s[static_cast<int>(a)]);
                before[a] = reach_ > 0 ? images_within(reach_, g, a, s[static_cast<int>(a)]) : Range{0, -1};
            }
            for (std::int32_t a = now[0].first; a <= now[0].last; ++a) {
                for (std::int32_t b = now[1].first; b <= now[1].last; ++b) {
                    for (std::int32_t c = now[2].first; c <= now[2].last; ++c) {
                        if (before[0].has(a) && before[1].has(b) && before[2].has(c)) {
                            continue;
                        }
                        const cell::Image image{a, b, c};
                        const Vec3 y = x + cell::shift(packing_.h, image);
                        const double r = packing_.radius[g];
                        fresh.emplace_back(
                            Point(Kernel::Point_3(y.x, y.y, y.z), r * r), static_cast<std::uint32_t>(points_.size())
                        );
                        points_.push_back({g, image});
                    }
                }
            }
        }
        triangulation_.insert(fresh.begin(), fresh.end());
        reach_ = reach;
    }

    /// Finds and numbers the tetrahedra of the part. @return the reach of images that they need.
    double keep_tetrahedra() {
        kept_.clear();
        double needed = 0;
        for (auto t = triangulation_.all_cells_begin(); t != triangulation_.all_cells_end(); ++t) {
            t->info() = PartTetrahedra::none;
            if (triangulation_.is_infinite(t)) {
                continue;
            }
            if (is_ours(t)) {
                t->info() = static_cast<std::uint32_t>(kept_.size());
                kept_.push_back(t);
            } else if (care_ == Care::Kept || !may_touch(t)) {
                continue;
            }
            needed = std::max(needed, needed_reach(t));
        }
        // A part inside one large void may have no centroid; what is missing otherwise shows when the parts are joined.
        const double widest = std::max({packing_.width.x, packing_.width.y, packing_.width.z});
        const bool may_be_empty = cuts_ != Cuts{1, 1, 1} && reach_ > widest;
        return kept_.empty() && !may_be_empty ? unlimited : needed;
    }

    /// Distance from the part within which a surface could be in conflict with this tetrahedron. A sphere (x, r) is in
    /// conflict where |x - P|^2 - r^2 is below the power of the center P; small spheres reach farthest.
    [[nodiscard]] double needed_reach(Regular::Cell_handle t) const {
        for (int k = 0; k < 4; ++k) {
            if (triangulation_.is_infinite(t->neighbor(k))) {
                return unlimited;
            }
        }
        std::array<Vec3, 4> x;
        std::array<double, 4> weight;
        for (int k = 0; k < 4; ++k) {
            const Point& point = t->vertex(k)->point();
            x[static_cast<std::size_t>(k)] = {point.x(), point.y(), point.z()};
            weight[static_cast<std::size_t>(k)] = point.weight();
        }
        const PowerCenter center = power_center(x, weight);
        // The center of a flat one lies between those of its neighbors, which are checked.
        if (center.is_flat) {
            return 0;
        }
        const Vec3 s = packing_.inverse_h * center.point;
        const double power = norm2(center.point - x[0]) - weight[0];
        const double ball = power > 0 ? std::sqrt(power + smallest_ * smallest_) - smallest_ : 0;
        double outside = -unlimited;
        for (int a = 0; a < 3; ++a) {
            const auto k = static_cast<std::size_t>(a);
            outside = std::max(outside, std::max(low_[k] - s[a], s[a] - high_[k]) * packing_.width[a]);
        }
        return outside + ball + 1e-6 * packing_.spacing; // cospherical images must be there as well
    }

    const ExactPacking& packing_;
    const Cuts& cuts_;
    const Part& part_;
    Care care_;
    std::array<double, 3> low_{}, high_{}; ///< of the part, fractional coordinates
    double smallest_;
    double reach_ = 0; ///< [-], of the surfaces of the images inserted
    Regular triangulation_;
    std::vector<Corner> points_;
    std::vector<Regular::Cell_handle> kept_;
};

} // namespace

PartTetrahedra triangulate_part(const ExactPacking& packing, const Cuts& cuts, const Part& part, Care care) {
    GhostTriangulation ghosts(packing, cuts, part, care);
    ghosts.cover();
    return ghosts.extract();
}

} // namespace suffuse::pores
