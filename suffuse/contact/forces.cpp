#include "suffuse/contact/forces.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/exact_sum.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <mutex>

namespace suffuse::contact {
namespace {

constexpr std::size_t tile_rows = 64;

using Row = std::array<double, tile_rows>;

struct alignas(64) Rows3 {
    Row x, y, z;
};

/// The two grains of each contact of a tile, side by side, and what the parts of the law leave to the next one.
struct alignas(64) Tile {
    Rows3 branch, velocity, spin_1, spin_2;
    Row radius_1, radius_2, bonded;
    Rows3 normal;
    Row overlap, stretch, normal_stiffness, within_reach;
    Rows3 shear_force, bending, twisting;
    Row normal_force, slip_limit, bending_limit, twisting_limit, touching;

    // The motion is not needed any more when the contact's action on its grains is known.
    Rows3& force() { return velocity; }

    Rows3& torque_1() { return spin_1; }

    Rows3& torque_2() { return spin_2; }
};

/// Displacement and velocity of a period against the home period.
struct alignas(64) Shift {
    Quad position, velocity;
};

/// The columns that the law reads and writes.
struct MemoryColumns {
    double *fx, *fy, *fz, *bx, *by, *bz, *nx, *ny, *nz, *tx, *ty, *tz, *overlap;
    std::uint8_t* bonded;

    explicit MemoryColumns(Contacts& c)
        : fx(c.shear_force.x.data()), fy(c.shear_force.y.data()), fz(c.shear_force.z.data()), bx(c.bending.x.data()),
          by(c.bending.y.data()), bz(c.bending.z.data()), nx(c.normal.x.data()), ny(c.normal.y.data()),
          nz(c.normal.z.data()), tx(c.twisting.x.data()), ty(c.twisting.y.data()), tz(c.twisting.z.data()),
          overlap(c.overlap.data()), bonded(c.bonded.data()) {}
};

/// What the loop over a domain reads and writes.
struct Work {
    const grains::MovingRow* grains;
    const std::uint32_t *first, *second, *second_sum;
    const std::uint16_t* image;
    const Shift* shifts;
    LawConstants law;
    double dt;
    SumQuantum quantum;
    double largest_force; ///< [N]
    MemoryColumns memory;
    grains::GrainSum* sums;
};

/// Sums of force (x) branch, in quanta, and whether a force is out of bounds.
struct StressSum {
    std::array<std::uint64_t, 9> quanta{};
    std::uint64_t wild = 0;
};

[[gnu::always_inline]] inline void
set_three(Rows3& rows, std::size_t k, const Quad& a, const Quad& b, const Quad& c, const Quad& d) {
    const std::array<Quad, 4> t = transposed(a, b, c, d);
    std::memcpy(&rows.x[k], &t[0], sizeof(Quad));
    std::memcpy(&rows.y[k], &t[1], sizeof(Quad));
    std::memcpy(&rows.z[k], &t[2], sizeof(Quad));
}

[[gnu::always_inline]] inline void
set_four(Rows3& rows, Row& last, std::size_t k, const Quad& a, const Quad& b, const Quad& c, const Quad& d) {
    const std::array<Quad, 4> t = transposed(a, b, c, d);
    std::memcpy(&rows.x[k], &t[0], sizeof(Quad));
    std::memcpy(&rows.y[k], &t[1], sizeof(Quad));
    std::memcpy(&rows.z[k], &t[2], sizeof(Quad));
    std::memcpy(&last[k], &t[3], sizeof(Quad));
}

[[gnu::always_inline]] inline Quad at(const Row& row, std::size_t k) {
    Quad q;
    std::memcpy(&q, &row[k], sizeof(Quad));
    return q;
}

[[gnu::always_inline]] inline std::array<Quad, 4> vectors(const Rows3& rows, std::size_t k) {
    return transposed(at(rows.x, k), at(rows.y, k), at(rows.z, k), Quad{});
}

[[gnu::always_inline]] inline void load(const Work& w, std::size_t begin, std::size_t rows, Tile& tile) {
    for (std::size_t k = 0; k < rows; k += 4) {
        std::array<Quad, 4> branch, velocity, spin_1, spin_2;
        for (std::size_t q = 0; q < 4; ++q) {
            const std::size_t c = begin + std::min(k + q, rows - 1); // short of rows: the last one again, unused
            const grains::MovingRow &i = w.grains[w.first[c]], &j = w.grains[w.second[c]];
            const Shift& shift = w.shifts[w.image[c]];
            branch[q] = j.position - i.position + shift.position;
            velocity[q] = j.velocity - i.velocity + shift.velocity;
            spin_1[q] = i.spin;
            spin_2[q] = j.spin;
        }
        set_three(tile.branch, k, branch[0], branch[1], branch[2], branch[3]);
        set_three(tile.velocity, k, velocity[0], velocity[1], velocity[2], velocity[3]);
        set_four(tile.spin_1, tile.radius_1, k, spin_1[0], spin_1[1], spin_1[2], spin_1[3]);
        set_four(tile.spin_2, tile.radius_2, k, spin_2[0], spin_2[1], spin_2[2], spin_2[3]);
    }
}

[[gnu::always_inline]] inline Triple<double> triple(const Rows3& rows, std::size_t k) {
    return {rows.x[k], rows.y[k], rows.z[k]};
}

[[gnu::always_inline]] inline void set(Rows3& rows, std::size_t k, const Triple<double>& v) {
    rows.x[k] = v.x, rows.y[k] = v.y, rows.z[k] = v.z;
}

[[gnu::always_inline]] inline void find_meetings(const LawConstants& law, std::size_t rows, Tile& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const Meeting<double> m = meet(law, triple(t.branch, k), t.radius_1[k], t.radius_2[k]);
        set(t.normal, k, m.normal);
        t.overlap[k] = m.overlap;
        t.stretch[k] = m.stretch;
        t.normal_stiffness[k] = m.normal_stiffness;
        t.within_reach[k] = m.within_reach;
    }
}

[[gnu::always_inline]] inline Meeting<double> meeting(const Tile& t, std::size_t k) {
    return {triple(t.normal, k), t.overlap[k], t.stretch[k], t.normal_stiffness[k], t.within_reach[k]};
}

template <bool Adhesive, bool Twisting>
[[gnu::always_inline]] inline void stretch_springs(
    const LawConstants& law, double dt, const MemoryColumns& m, std::size_t begin, std::size_t rows, Tile& t
) {
    for (std::size_t k = 0; Adhesive && k < rows; ++k) {
        t.bonded[k] = m.bonded[begin + k];
    }
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        const GrainPair<double> pair{triple(t.branch, k), triple(t.velocity, k), triple(t.spin_1, k),
                                     triple(t.spin_2, k), t.radius_1[k],         t.radius_2[k]};
        ContactMemory<double> memory{
            {m.fx[c], m.fy[c], m.fz[c]}, {m.bx[c], m.by[c], m.bz[c]}, {}, {m.nx[c], m.ny[c], m.nz[c]}, 0};
        if constexpr (Adhesive) {
            memory.bonded = t.bonded[k];
        }
        if constexpr (Twisting) {
            memory.twisting = {m.tx[c], m.ty[c], m.tz[c]};
        }
        const Limits<double> limits = stretch<Adhesive, Twisting>(law, dt, pair, meeting(t, k), memory);
        set(t.shear_force, k, memory.shear_force);
        set(t.bending, k, memory.bending);
        if constexpr (Adhesive) {
            t.bonded[k] = memory.bonded;
        }
        if constexpr (Twisting) {
            set(t.twisting, k, memory.twisting);
            t.twisting_limit[k] = limits.twisting;
        }
        t.normal_force[k] = limits.normal_force;
        t.slip_limit[k] = limits.slip;
        t.bending_limit[k] = limits.bending;
        t.touching[k] = limits.touching;
    }
    for (std::size_t k = 0; Adhesive && k < rows; ++k) {
        m.bonded[begin + k] = static_cast<std::uint8_t>(t.bonded[k]);
    }
}

template <bool Twisting>
[[gnu::always_inline]] inline void cut_springs(const MemoryColumns& m, std::size_t begin, std::size_t rows, Tile& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        const Limits<double> limits{
            t.normal_force[k], t.slip_limit[k], t.bending_limit[k], Twisting ? t.twisting_limit[k] : 0.0,
            t.touching[k]};
        ContactMemory<double> memory{triple(t.shear_force, k), triple(t.bending, k), {}, {}, 0};
        if constexpr (Twisting) {
            memory.twisting = triple(t.twisting, k);
        }
        const ContactOutcome<double> out = cut<Twisting>(meeting(t, k), limits, t.radius_1[k], t.radius_2[k], memory);
        m.fx[c] = memory.shear_force.x, m.fy[c] = memory.shear_force.y, m.fz[c] = memory.shear_force.z;
        m.bx[c] = memory.bending.x, m.by[c] = memory.bending.y, m.bz[c] = memory.bending.z;
        m.nx[c] = memory.normal.x, m.ny[c] = memory.normal.y, m.nz[c] = memory.normal.z;
        m.overlap[c] = out.overlap;
        if constexpr (Twisting) {
            m.tx[c] = memory.twisting.x, m.ty[c] = memory.twisting.y, m.tz[c] = memory.twisting.z;
        }
        set(t.force(), k, out.force);
        set(t.torque_1(), k, out.torque_1);
        set(t.torque_2(), k, out.torque_2);
    }
}

[[gnu::always_inline]] inline void add_stress(
    const Rows3& force, const Rows3& branch, std::size_t rows, const SumQuantum& quantum, double largest_force,
    StressSum& sum
) {
    std::array<std::uint64_t, 9> s = sum.quanta;
    std::uint64_t wild = sum.wild;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const double fx = force.x[k], fy = force.y[k], fz = force.z[k];
        wild |= std::abs(fx) + std::abs(fy) + std::abs(fz) <= largest_force ? 0U : 1U;
        s[0] += quantum.count(fx * branch.x[k]);
        s[1] += quantum.count(fx * branch.y[k]);
        s[2] += quantum.count(fx * branch.z[k]);
        s[3] += quantum.count(fy * branch.x[k]);
        s[4] += quantum.count(fy * branch.y[k]);
        s[5] += quantum.count(fy * branch.z[k]);
        s[6] += quantum.count(fz * branch.x[k]);
        s[7] += quantum.count(fz * branch.y[k]);
        s[8] += quantum.count(fz * branch.z[k]);
    }
    sum = {s, wild};
}

[[gnu::always_inline]] inline void add_to_grains(const Work& w, std::size_t begin, std::size_t rows, Tile& t) {
    for (std::size_t k = 0; k < rows; k += 4) {
        const std::array<Quad, 4> force = vectors(t.force(), k), torque_1 = vectors(t.torque_1(), k),
                                  torque_2 = vectors(t.torque_2(), k);
        for (std::size_t q = 0; q < std::min<std::size_t>(4, rows - k); ++q) {
            const std::size_t c = begin + k + q;
            grains::GrainSum& first = w.sums[w.first[c]];
            first.force -= force[q];
            first.torque += torque_1[q];
            grains::GrainSum& second = w.sums[w.second_sum[c]];
            second.force += force[q];
            second.torque += torque_2[q];
        }
    }
}

template <bool Adhesive, bool Twisting>
[[gnu::always_inline]] inline void press(const Work& w, std::size_t begin, std::size_t end, StressSum& stress) {
    Tile tile;
    for (std::size_t c = begin; c < end; c += tile_rows) {
        const std::size_t rows = std::min(tile_rows, end - c);
        load(w, c, rows, tile);
        find_meetings(w.law, rows, tile);
        stretch_springs<Adhesive, Twisting>(w.law, w.dt, w.memory, c, rows, tile);
        cut_springs<Twisting>(w.memory, c, rows, tile);
        add_stress(tile.force(), tile.branch, rows, w.quantum, w.largest_force, stress);
        add_to_grains(w, c, rows, tile);
    }
}

SUFFUSE_CLONES void press_plain(const Work& w, std::size_t begin, std::size_t end, StressSum& stress) {
    press<false, false>(w, begin, end, stress);
}

SUFFUSE_CLONES void press_twisting(const Work& w, std::size_t begin, std::size_t end, StressSum& stress) {
    press<false, true>(w, begin, end, stress);
}

SUFFUSE_CLONES void press_adhesive(const Work& w, std::size_t begin, std::size_t end, StressSum& stress) {
    press<true, false>(w, begin, end, stress);
}

SUFFUSE_CLONES void press_all(const Work& w, std::size_t begin, std::size_t end, StressSum& stress) {
    press<true, true>(w, begin, end, stress);
}

auto choose_loop(const Contacts& contacts) {
    const bool adhesive = !contacts.bonded.empty(), twisting = contacts.twisting.size() > 0;
    return adhesive ? (twisting ? press_all : press_adhesive) : (twisting ? press_twisting : press_plain);
}

} // namespace

Pressed compute_forces(
    const std::vector<grains::MovingRow>& grains, const SumPlan& plan, const Surroundings& around,
    const LawConstants& law, Contacts& contacts, std::vector<grains::GrainSum>& sums
) {
    std::vector<Shift> shifts;
    for (const cell::Image& image : plan.images) {
        shifts.push_back({quad(cell::shift(around.h, image), 0), quad(cell::shift(around.image_velocity, image), 0)});
    }
    // However much they overlap, grains push with at most E r2; with shear, the sum of the components stays below four
    // times that. And no stress reaches the modulus. The quantum follows from the state alone, as the same bits after a
    // resume ask for.
    const double r = around.largest_radius, largest_force = 2 * law.twice_modulus * r * r;
    const SumQuantum quantum(largest_force * 2 * r, law.twice_modulus * std::abs(determinant(around.h)));
    const Work work{
        grains.data(),
        contacts.first.data(),
        contacts.second.data(),
        plan.second_sum.data(),
        plan.image.data(),
        shifts.data(),
        law,
        around.dt,
        quantum,
        largest_force,
        MemoryColumns(contacts),
        sums.data()};
    const auto press_loop = choose_loop(contacts);
    StressSum total;
    std::mutex adding; // integers: the order does not matter
    parallel_for(plan.domains(), 1, [&](std::size_t first, std::size_t last) {
        StressSum part;
        for (std::size_t d = first; d < last; ++d) {
            const std::size_t begin = d * domain_grains, end = std::min(plan.grains, begin + domain_grains);
            std::fill(sums.data() + begin, sums.data() + end, grains::GrainSum{});
            press_loop(work, plan.domain_start[d], plan.domain_start[d + 1], part);
        }
        const std::lock_guard lock(adding);
        for (std::size_t q = 0; q < part.quanta.size(); ++q) {
            total.quanta[q] += part.quanta[q];
        }
        total.wild |= part.wild;
    });
    Pressed pressed;
    for (std::size_t q = 0; q < total.quanta.size(); ++q) {
        pressed.force_branch.m[q / 3][q % 3] = quantum.value(total.quanta[q]);
    }
    pressed.wild = total.wild != 0;
    return pressed;
}

} // namespace suffuse::contact
