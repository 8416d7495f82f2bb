#include "suffuse/pores/triangulation.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/pores/lattice.hpp"
#include "suffuse/pores/power_center.hpp"
#include "suffuse/pores/triangulation_check.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace suffuse::pores {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<
    std::uint32_t, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Regular = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Point = Regular::Weighted_point;

constexpr std::uint32_t not_kept = std::numeric_limits<std::uint32_t>::max();
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// A grain, or one of its images.
struct Corner {
    std::uint32_t grain;
    ShortImage image;

    auto operator<=>(const Corner&) const = default;
};

/// Corners of a tetrahedron or of a facet, moved so that the grain of lowest row is at home: the same for all its
/// images.
template <std::size_t N>
struct Canonical {
    std::array<Corner, N> corners;
    ShortImage moved; ///< what was given = this, moved by these periods
};

template <std::size_t N>
Canonical<N> canonical(const std::array<Corner, N>& given) {
    Canonical<N> best{};
    bool any = false;
    const std::uint32_t lowest = std::min_element(given.begin(), given.end())->grain;
    for (const Corner& origin : given) { // several where a grain is joined to its own image
        if (origin.grain != lowest) {
            continue;
        }
        Canonical<N> c{given, origin.image};
        for (Corner& corner : c.corners) {
            corner.image = corner.image - origin.image;
        }
        std::sort(c.corners.begin(), c.corners.end());
        if (!any || c.corners < best.corners) {
            best = c;
        }
        any = true;
    }
    return best;
}

/// Place along a curve that visits the eighths of a cube one after the other, and so on within each (Morton).
std::uint64_t place_on_curve(const Vec3& s) {
    constexpr int bits = 16;
    std::uint64_t place = 0;
    for (int a = 0; a < 3; ++a) {
        const auto cut = static_cast<std::uint64_t>(std::ldexp(std::clamp(s[a], 0.0, 1 - 1e-9), bits));
        for (int b = 0; b < bits; ++b) {
            place |= (cut >> b & 1) << (3 * b + a);
        }
    }
    return place;
}

class GhostTriangulation {
public:
    explicit GhostTriangulation(const ExactPacking& packing)
        : packing_(packing), smallest_(*std::min_element(packing.radius.begin(), packing.radius.end())) {}

    /// Adds images around the cell until no image that is left out can be in conflict with a tetrahedron that is kept.
    void cover() {
        double reach = initial_reach * packing_.spacing;
        insert_images(reach);
        for (int round = 0; round < 60; ++round) {
            const double needed = keep_tetrahedra();
            if (needed <= reach_) {
                return number_tetrahedra();
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

    /// The tetrahedra kept, with neighbors; false where images of the cell are not triangulated alike.
    bool extract(Triangulation& out) const {
        std::vector<std::uint8_t> seen(packing_.radius.size(), 0);
        std::vector<OpenFacet> open;
        out.grain.resize(kept_.size()), out.grain_image.resize(kept_.size());
        out.neighbor.resize(kept_.size()), out.neighbor_image.resize(kept_.size());
        for (std::uint32_t p = 0; p < kept_.size(); ++p) {
            const auto tetrahedron = corners(kept_[p]);
            for (std::uint32_t k = 0; k < 4; ++k) {
                const Corner& c = tetrahedron[k];
                seen[c.grain] = 1;
                out.grain[p][k] = c.grain;
                out.grain_image[p][k] = packing_.basis.original(cell::Image(c.image) - packing_.period[c.grain]);
                out.neighbor[p][k] = kept_[p]->neighbor(static_cast<int>(k))->info();
                if (out.neighbor[p][k] != not_kept) {
                    continue;
                }
                const auto facet =
                    std::array{tetrahedron[(k + 1) % 4], tetrahedron[(k + 2) % 4], tetrahedron[(k + 3) % 4]};
                open.push_back({canonical(facet), p, k});
            }
        }
        for (std::uint32_t g = 0; g < seen.size(); ++g) {
            if (seen[g] == 0) {
                out.hidden.push_back(g);
            }
        }
        out.ghosts = points_.size() - packing_.radius.size();
        out.margin = reach_ * packing_.unit;
        return close(open, out);
    }

private:
    /// A facet of a kept tetrahedron whose other side is an image of a kept one. (That image as triangulated here may
    /// be wrong: only kept tetrahedra are known to have all images around them.)
    struct OpenFacet {
        Canonical<3> facet;
        std::uint32_t p, k;
    };

    /// Joins the two sides of every open facet; false where there are not two.
    bool close(std::vector<OpenFacet>& open, Triangulation& out) const {
        std::sort(open.begin(), open.end(), [](const OpenFacet& one, const OpenFacet& other) {
            return one.facet.corners < other.facet.corners;
        });
        if (open.size() % 2 != 0) {
            return false;
        }
        for (std::size_t f = 0; f < open.size(); f += 2) {
            const OpenFacet &one = open[f], &other = open[f + 1];
            if (one.facet.corners != other.facet.corners) {
                return false;
            }
            const ShortImage between = packing_.basis.original(cell::Image(one.facet.moved - other.facet.moved));
            out.neighbor[one.p][one.k] = other.p;
            out.neighbor_image[one.p][one.k] = between;
            out.neighbor[other.p][other.k] = one.p;
            out.neighbor_image[other.p][other.k] = -between;
        }
        return true;
    }

    static constexpr double initial_reach = 0.8; ///< in spacings: enough for most packings of sand

    [[nodiscard]] std::array<Corner, 4> corners(Regular::Cell_handle t) const {
        return {
            points_[t->vertex(0)->info()], points_[t->vertex(1)->info()], points_[t->vertex(2)->info()],
            points_[t->vertex(3)->info()]};
    }

    static Vec3 centroid(Regular::Cell_handle t) {
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

    /// The period that the centroid of a tetrahedron lies in. Near a face of the cell rounding must not let two images
    /// differ, so that it is decided on the canonical image there.
    [[nodiscard]] cell::Image home(Regular::Cell_handle t) const {
        const Vec3 s = packing_.inverse_h * centroid(t);
        const cell::Image period = {floor(s.x), floor(s.y), floor(s.z)};
        const auto near_a_face = [](double x) { return std::abs(x - std::nearbyint(x)) < 1e-9; };
        if (!near_a_face(s.x) && !near_a_face(s.y) && !near_a_face(s.z)) {
            return period;
        }
        const Canonical<4> c = canonical(corners(t));
        const Vec3 corner_sum = place(c.corners[0]) + place(c.corners[1]) + place(c.corners[2]) + place(c.corners[3]);
        const Vec3 decisive = 0.25 * (packing_.inverse_h * corner_sum);
        return cell::Image(c.moved) + cell::Image{floor(decisive.x), floor(decisive.y), floor(decisive.z)};
    }

    static std::int32_t floor(double x) { return static_cast<std::int32_t>(std::floor(x)); }

    /// Whole periods n for which a surface of radius r at fractional coordinate s + n is within `reach` of the cell.
    struct Range {
        std::int32_t first, last;
    };

    [[nodiscard]] Range images_within(double reach, std::size_t g, int axis, double s) const {
        if (!(reach > 0)) {
            return {0, 0};
        }
        const double m = (reach + packing_.radius[g]) / packing_.width[axis];
        return {-floor(m + s), floor(1 + m - s)};
    }

    /// Inserts the images within `reach` that are not there yet.
    void insert_images(double reach) {
        std::vector<std::pair<Point, std::uint32_t>> fresh;
        for (std::uint32_t g = 0; g < packing_.radius.size(); ++g) {
            const Vec3 s = packing_.inverse_h * packing_.position[g];
            const Vec3& x = packing_.position[g];
            std::array<Range, 3> now{}, before{};
            for (int a = 0; a < 3; ++a) {
                now[static_cast<std::size_t>(a)] = images_within(reach, g, a, s[a]);
                before[static_cast<std::size_t>(a)] = images_within(reach_, g, a, s[a]);
            }
            const auto among = [](const Range& range, std::int32_t n) { return range.first <= n && n <= range.last; };
            for (std::int32_t a = now[0].first; a <= now[0].last; ++a) {
                for (std::int32_t b = now[1].first; b <= now[1].last; ++b) {
                    for (std::int32_t c = now[2].first; c <= now[2].last; ++c) {
                        const bool there = among(before[0], a) && among(before[1], b) && among(before[2], c);
                        if (reach_ > 0 && there) {
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

    /// Finds the tetrahedra whose centroid lies in the cell. @return the reach of images that they need.
    double keep_tetrahedra() {
        kept_.clear();
        double needed = 0;
        for (auto t = triangulation_.all_cells_begin(); t != triangulation_.all_cells_end(); ++t) {
            t->info() = not_kept;
            if (triangulation_.is_infinite(t) || home(t) != cell::Image{}) {
                continue;
            }
            kept_.push_back(t);
            needed = std::max(needed, needed_reach(t));
        }
        return kept_.empty() ? unlimited : needed;
    }

    /// Numbers the kept tetrahedra along a curve that fills the cell, so that what is close in space is close in
    /// memory.
    void number_tetrahedra() {
        std::vector<std::pair<std::uint64_t, Regular::Cell_handle>> order;
        order.reserve(kept_.size());
        for (const Regular::Cell_handle t : kept_) {
            order.emplace_back(place_on_curve(packing_.inverse_h * centroid(t)), t);
        }
        std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::uint32_t p = 0; p < kept_.size(); ++p) {
            kept_[p] = order[p].second;
            kept_[p]->info() = p;
        }
    }

    /// Distance from the cell within which a surface could be in conflict with this tetrahedron. A sphere (x, r) is in
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
            outside = std::max(outside, std::max(-s[a], s[a] - 1) * packing_.width[a]);
        }
        return outside + ball + 1e-6 * packing_.spacing; // cospherical images must be there as well
    }

    const ExactPacking& packing_;
    double smallest_;
    double reach_ = 0; ///< [-], of the surfaces of the images inserted
    Regular triangulation_;
    std::vector<Corner> points_;
    std::vector<Regular::Cell_handle> kept_;
};

} // namespace

Triangulation triangulate(const Mat3& h, std::span<const Vec3> position, std::span<const double> radius) {
    // Exact predicates with a translation-invariant tie rule serve lattices as they are. Should images of the cell be
    // triangulated differently after all, grains are moved by a trifle to decide the ties; geometry keeps the true
    // ones.
    std::string defect;
    for (const double jitter : {0.0, 1e-9, 1e-7}) {
        const ExactPacking packing = exact_packing(h, position, radius, jitter);
        GhostTriangulation ghosts(packing);
        ghosts.cover();
        Triangulation result;
        if (!ghosts.extract(result)) {
            defect = "images of the cell are not triangulated alike";
            continue;
        }
        const auto found = find_defect(result, h, position);
        if (!found) {
            result.jitter = jitter * packing.spacing * packing.unit;
            return result;
        }
        defect = *found;
    }
    throw GeometryError(fmt::format(
        "pores: the triangulation of {} grains is not that of a periodic cell: {}. Do grains coincide?", radius.size(),
        defect
    ));
}

} // namespace suffuse::pores
