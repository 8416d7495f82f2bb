#include "suffuse/flow/bounded_drag.hpp"

#include "suffuse/base/constants.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/flow/known_error.hpp"
#include "suffuse/flow/seepage.hpp"
#include "suffuse/flow/throat_edges.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/packings.hpp"
#include "tests/support/reference.hpp"
#include <random>
#include <sstream>

namespace suffuse::flow {
namespace {

using test::Packing;

/// A packing of tests/reference/network, with the forces of the resolved flow and of the law's first implementation.
struct Resolved {
    nlohmann::json about;
    Packing packing;
    std::vector<bool> is_coarse;
    std::vector<Vec3> force, prototype; ///< [N]

    explicit Resolved(const std::string& name) : about(test::read_reference_json("network/" + name + ".json")) {
        packing = test::reference_spheres("network/" + name);
        std::istringstream rows(test::read_reference("network/" + name + ".csv.gz"));
        std::string line;
        std::getline(rows, line);
        while (std::getline(rows, line)) {
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream row(line);
            double x = 0, y = 0, z = 0, r = 0;
            bool coarse = false;
            Vec3 f, p;
            row >> x >> y >> z >> r >> coarse >> f.x >> f.y >> f.z >> p.x >> p.y >> p.z;
            is_coarse.push_back(coarse), force.push_back(f), prototype.push_back(p);
        }
    }

    [[nodiscard]] Seepage seep(Conductance law = Conductance::Bounded) const {
        return solve_seepage({packing.h, {}}, packing.position, packing.radius, {0.1, {0, 0, 1}}, {.conductance = law});
    }

    [[nodiscard]] Packing coarse() const {
        Packing part{packing.h, {}, {}};
        for (std::size_t g = 0; g < packing.size(); ++g) {
            if (is_coarse[g]) {
                part.position.push_back(packing.position[g]), part.radius.push_back(packing.radius[g]);
            }
        }
        return part;
    }
};

double permeability(const Packing& packing, const Vec3& direction = {0, 0, 1}) {
    const Fluid fluid{.conductance = Conductance::Bounded};
    return solve_seepage({packing.h, {}}, packing.position, packing.radius, {1, direction}, fluid).permeability;
}

/// How forces follow others on some grains, along z but for the error, which is of whole vectors.
struct Likeness {
    double sum = 0, correlation = 0, error = 0;
};

Likeness compare(const std::vector<Vec3>& force, const std::vector<Vec3>& other, const std::vector<bool>& skipped) {
    double n = 0, a = 0, b = 0, aa = 0, ab = 0, bb = 0, off = 0, whole = 0;
    for (std::size_t g = 0; g < force.size(); ++g) {
        if (skipped[g]) {
            continue;
        }
        const double f = force[g].z, o = other[g].z;
        ++n, a += f, b += o, aa += f * f, ab += f * o, bb += o * o;
        off += norm2(force[g] - other[g]), whole += norm2(other[g]);
    }
    const double correlation = (n * ab - a * b) / std::sqrt((n * aa - a * a) * (n * bb - b * b));
    return {a / b, correlation, std::sqrt(off / whole)};
}

TEST(BoundedDrag, IsThatOfItsPrototype) {
    for (const char* name : {"m36", "m55", "q3_20", "q6_5", "q10_1"}) {
        const Resolved resolved(name);
        const Seepage seepage = resolved.seep();
        EXPECT_NEAR(seepage.permeability / resolved.about["k_prototype"].get<double>(), 1, 1e-6) << name;
        const std::vector<bool> none(resolved.packing.size(), false);
        const Likeness all = compare(seepage.grain_force, resolved.prototype, none);
        EXPECT_NEAR(all.sum, 1, 1e-5) << name; // six digits in the file
        EXPECT_LE(all.error, 1e-4) << name;
        EXPECT_GE(all.correlation, 0.99999) << name;
        EXPECT_LE(seepage.force_sum_error, 1e-10) << name;
    }
}

TEST(BoundedDrag, FollowsTheResolvedFlow) {
    // Limits of one direction of a packing; those of one grain in a hundred are wider, as few and lone grains are
    // harder.
    struct Case {
        const char* name;
        double k, sum, correlation, error;
    };

    for (const Case& c :
         {Case{"q3_20", 0.10, 0.08, 0.92, 0.25}, {"q6_5", 0.10, 0.08, 0.92, 0.25}, {"q10_1", 0.20, 0.15, 0.88, 0.40}}) {
        const Resolved resolved(c.name);
        const Seepage seepage = resolved.seep();
        const double k = resolved.about["k_resolved"], coarse = resolved.about["k_resolved_coarse"];
        EXPECT_NEAR(seepage.permeability / k, 1, c.k) << c.name;
        EXPECT_NEAR(permeability(resolved.coarse()) / coarse, 1, 0.20) << c.name; // a skeleton of ten grains
        const Likeness fines = compare(seepage.grain_force, resolved.force, resolved.is_coarse);
        EXPECT_NEAR(fines.sum, 1, c.sum) << c.name;
        EXPECT_GE(fines.correlation, c.correlation) << c.name;
        EXPECT_LE(fines.error, c.error) << c.name;
        const std::vector<Vec3> by_yade = resolved.seep(Conductance::Yade).grain_force;
        EXPECT_LT(fines.error, 0.7 * compare(by_yade, resolved.force, resolved.is_coarse).error) << c.name;
    }
    for (const auto& [name, limit] : {std::pair{"m36", 0.05}, {"m55", 0.20}}) { // dense, and a cloud
        const Resolved resolved(name);
        EXPECT_NEAR(resolved.seep().permeability / resolved.about["k_resolved"].get<double>(), 1, limit) << name;
    }
}

TEST(BoundedDrag, OfLatticesIsWithinItsKnownErrorOfTheExactOrResolvedFlow) {
    // k/R2 = 2/(9 x solid fraction x K). K of touching grains is exact [Zick and Homsy 1982]; of those apart it is of
    // the flow resolved with 40 boxes across a cell. What the law gives over it is held to 1 %.
    struct Case {
        std::vector<Vec3> places;
        double nearest; ///< distance of neighbors over the side of the cube [-]
        std::array<double, 5> drag, ratio;
    };

    const std::vector<Vec3> simple{{0.1, 0.2, 0.3}}, body{{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}},
        face{{0.1, 0.2, 0.3}, {0.6, 0.7, 0.3}, {0.6, 0.2, 0.8}, {0.1, 0.7, 0.8}};
    constexpr std::array<double, 5> apart = {1, 1.02, 1.05, 1.1, 1.2}; // over a diameter
    for (const Case& c :
         {Case{simple, 1, {42.1, 35.71, 28.50, 20.47, 12.28}, {0.93, 0.99, 1.04, 1.06, 1.01}},
          {body, std::sqrt(0.75), {162.9, 120.57, 81.03, 47.34, 22.27}, {1.00, 1.04, 1.04, 0.99, 1.03}},
          {face, std::sqrt(0.5), {435, 273.02, 154.59, 74.10, 28.97}, {1.00, 1.09, 1.09, 1.05, 1.07}}}) {
        for (std::size_t k = 0; k < apart.size(); ++k) {
            const double r = 1e-3, side = 2 * r * apart.at(k) / c.nearest;
            const Packing packing = test::lattice(2, side, r, c.places);
            const double solid = static_cast<double>(c.places.size()) * 4 * pi / 3 * std::pow(r / side, 3);
            const double exact = 2 * r * r / (9 * solid * c.drag.at(k));
            const double ratio = permeability(packing, {0.3, -0.5, 0.8}) / exact;
            const std::vector<std::uint8_t> none(packing.size());
            const Mixture mixture = describe_mixture(packing.radius, none, determinant(packing.h));
            EXPECT_NEAR(ratio, 1, known_error(Conductance::Bounded, mixture).permeability.value()) << solid;
            EXPECT_NEAR(ratio / c.ratio.at(k), 1, 0.01) << solid;
        }
    }
}

TEST(BoundedDrag, OfALatticeIsThatOfItsTriclinicCell) {
    // A face-centered cube, and a cell of one grain along three of its diagonals.
    for (const double apart : {1.0, 1.05, 1.2}) {
        const double side = 2 * apart * std::sqrt(2.0), half = 0.5 * side;
        const Packing cube =
            test::lattice(1, side, 1, {{0.1, 0.2, 0.3}, {0.6, 0.7, 0.3}, {0.6, 0.2, 0.8}, {0.1, 0.7, 0.8}});
        const Packing primitive{{{{{0, half, half}, {half, 0, half}, {half, half, 0}}}}, {{0.1, 0.2, 0.3}}, {1}};
        const Vec3 direction{0.3, -0.5, 0.8};
        EXPECT_NEAR(permeability(primitive, direction) / permeability(cube, direction), 1, 1e-5) << apart;
    }
}

TEST(BoundedDrag, HasTheSameBitsForAnyThreads) {
    const Resolved resolved("q6_5");
    const int before = thread_count();
    set_thread_count(1);
    const Seepage one = resolved.seep();
    for (const int threads : {2, 3}) {
        set_thread_count(threads);
        const Seepage other = resolved.seep();
        EXPECT_EQ(other.conductance, one.conductance);
        EXPECT_EQ(other.grain_force, one.grain_force);
        EXPECT_EQ(other.permeability, one.permeability);
    }
    set_thread_count(before);
}

/// Adds `fines` grains of radius `r` at random places between the others.
Packing with_fines(Packing packing, std::size_t fines, double r, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    const Mat3 to_cell = inverse(packing.h);
    const auto is_free = [&](const Vec3& x) {
        for (std::size_t g = 0; g < packing.size(); ++g) {
            Vec3 apart = to_cell * (x - packing.position[g]);
            for (int a = 0; a < 3; ++a) {
                apart[a] -= std::round(apart[a]);
            }
            if (norm(packing.h * apart) < r + packing.radius[g]) {
                return false;
            }
        }
        return true;
    };
    for (std::size_t placed = 0; placed < fines;) {
        const Vec3 x = packing.h * Vec3{uniform(), uniform(), uniform()};
        if (is_free(x)) {
            packing.position.push_back(x), packing.radius.push_back(r);
            ++placed;
        }
    }
    return packing;
}

TEST(BoundedDrag, FinesDoNotRaiseThePermeability) {
    // A lone grain cuts the water into other pores wherever it lies, however small it is: that alone moves the
    // permeability of a dozen grains by up to 4 % either way. In the mean over places little is left of it.
    const Packing coarse = Resolved("q3_20").coarse(); // a dozen grains
    const double size = coarse.radius.front(), alone = permeability(coarse);
    for (const auto& [fines, ratio] :
         {std::pair{1U, 3.0}, {10U, 3.0}, {1U, 10.0}, {100U, 10.0}, {1U, 100.0}, {600U, 100.0}}) {
        constexpr unsigned places = 10;
        double mean = 0;
        for (unsigned seed = 1; seed <= places; ++seed) {
            const double k = permeability(with_fines(coarse, fines, size / ratio, seed)) / alone;
            mean += k / places;
            EXPECT_LE(k, 1.05) << fines << " of ratio " << ratio;
            EXPECT_GE(k, 0.3) << fines << " of ratio " << ratio;
        }
        EXPECT_LE(mean, 1.02) << fines << " of ratio " << ratio;
    }
}

TEST(BoundedDrag, OfOneFineInACellOfOneGrainIsNearTheResolvedFlow) {
    // Over the coarse grain's own, resolved with 40 boxes across the cell and more. A fine in the middle of the void
    // cuts it into pores that were one body. Water moves faster through them: by up to a third where grains touch.
    struct Case {
        double large, ratio, resolved, off;
    };

    for (const Case& c :
         {Case{0.5, 3, 0.668, 0.26},
          {0.5, 5, 0.850, 0.33},
          {0.5, 10, 0.939, 0.36},
          {0.42, 3, 0.721, 0.08},
          {0.42, 5, 0.853, 0.08},
          {0.42, 10, 0.934, 0.08},
          {0.35, 3, 0.739, 0.08},
          {0.35, 5, 0.853, 0.08},
          {0.35, 10, 0.930, 0.08}}) {
        Packing packing = test::lattice(1, 1, c.large, {{0.1, 0.2, 0.3}});
        const double alone = permeability(packing);
        packing.position.push_back({0.6, 0.7, 0.8}), packing.radius.push_back(c.large / c.ratio);
        EXPECT_NEAR(permeability(packing) / alone / c.resolved, 1, c.off) << c.large << " " << c.ratio;
    }
}

TEST(BoundedDrag, OfOverlappingLatticesIsNearTheResolvedFlow) {
    // Neighbors nearer than a diameter by 2 and 5 % of it; resolved with 40 boxes across the cell. Beyond a fiftieth of
    // the void covered twice, errors are larger.
    const std::vector<Vec3> simple{{0.1, 0.2, 0.3}}, body{{0.1, 0.2, 0.3}, {0.6, 0.7, 0.8}},
        face{{0.1, 0.2, 0.3}, {0.6, 0.7, 0.3}, {0.6, 0.2, 0.8}, {0.1, 0.7, 0.8}};

    struct Case {
        const std::vector<Vec3>& places;
        double nearest, apart, resolved, pairs; // of neighbors a grain
    };

    for (const Case& c :
         {Case{simple, 1, 0.98, 0.0079229, 3},
          {simple, 1, 0.95, 0.0053668, 3},
          {body, std::sqrt(0.75), 0.98, 0.00135, 4},
          {body, std::sqrt(0.75), 0.95, 0.00067198, 4},
          {face, std::sqrt(0.5), 0.98, 0.00037772, 6},
          {face, std::sqrt(0.5), 0.95, 0.00012904, 6}}) {
        const Packing packing = test::lattice(2, 2 * c.apart / c.nearest, 1, c.places);
        const Seepage s = solve_seepage({packing.h, {}}, packing.position, packing.radius, {1, {0, 0, 1}}, {});
        Mixture mixture =
            describe_mixture(packing.radius, std::vector<std::uint8_t>(packing.size()), determinant(packing.h));
        mixture.overlap = s.overlap;
        EXPECT_NEAR(s.permeability / c.resolved, 1, known_error(Conductance::Bounded, mixture).permeability.value())
            << c.apart;
        const double grains = static_cast<double>(packing.size());
        const double common = grains * c.pairs * 2 * pi * lens_of(1, 1, 2 * c.apart).volume;
        const double water = determinant(packing.h) - grains * 4 * pi / 3 + common;
        EXPECT_NEAR(s.overlap / (common / water), 1, 1e-9) << c.apart;
        EXPECT_LE(s.force_sum_error, 1e-10);
    }
}

TEST(BoundedDrag, SeesChannelsAmongGrains) {
    const Resolved resolved("m36");
    EXPECT_LT(resolved.seep().channeling, 1.26);
    Packing slot{resolved.packing.h, {}, {}};
    for (std::size_t g = 0; g < resolved.packing.size(); ++g) {
        const double width = slot.h(0, 0), x = resolved.packing.position[g].x;
        if (x - width * std::floor(x / width) > 0.35 * width) {
            slot.position.push_back(resolved.packing.position[g]), slot.radius.push_back(resolved.packing.radius[g]);
        }
    }
    const Seepage along = solve_seepage({slot.h, {}}, slot.position, slot.radius, {1, {0, 0, 1}}, {});
    EXPECT_GT(along.channeling, 1.45);
    EXPECT_LT(solve_seepage({slot.h, {}}, slot.position, slot.radius, {1, {1, 0, 0}}, {}).channeling, 1.26);
}

TEST(BoundedDrag, DoesNotDependOnHowTheCellIsWritten) {
    const Resolved resolved("q10_1");
    Packing other = resolved.packing;
    other.h = other.h * Mat3{{{{1, 2, 0}, {0, 1, -1}, {0, 0, 1}}}};
    for (Vec3& x : other.position) {
        x += resolved.packing.h.column(1);
    }
    EXPECT_NEAR(permeability(other) / permeability(resolved.packing), 1, 1e-9);
}

} // namespace
} // namespace suffuse::flow
