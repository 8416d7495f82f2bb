#include "suffuse/contact/contact_loop.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/contact/opening.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/contact/tile.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::contact {
namespace {

/// Copies the grains of the contacts `row(0)` to `row(3)` into rows `k` to `k + 3` of the tile; their motion only where
/// `Moving`.
template <bool Moving, class Real, class RowOf>
[[gnu::always_inline]] inline void load_four(const DomainWork<Real>& w, std::size_t k, RowOf&& row, Tile<Real>& tile) {
    Double4x4 branch, velocity, spin_1, spin_2;
    for (std::size_t q = 0; q < 4; ++q) {
        const std::size_t c = row(q);
        const grains::MovingRow &i = w.grains[w.first[c]], &j = w.grains[w.second[c]];
        const ImageShift& shift = w.shifts[w.image[c]];
        branch[q] = j.position - i.position + shift.position;
        if constexpr (Moving) {
            velocity[q] = j.velocity - i.velocity + shift.velocity;
        }
        spin_1[q] = i.spin;
        spin_2[q] = j.spin;
    }
    const auto columns = [](const Double4x4& r) { return transposed(r[0], r[1], r[2], r[3]); };
    put(tile.branch, k, columns(branch));
    const Double4x4 first = columns(spin_1), second = columns(spin_2);
    if constexpr (Moving) {
        put(tile.velocity, k, columns(velocity));
        put(tile.spin_1, k, first);
        put(tile.spin_2, k, second);
    }
    put(tile.exact_radius_1, k, first[3]);
    put(tile.exact_radius_2, k, second[3]);
}

template <bool Moving, class Real>
[[gnu::always_inline]] inline void
load(const DomainWork<Real>& w, std::size_t begin, std::size_t rows, Tile<Real>& tile) {
    std::size_t k = 0;
    for (; k + 4 <= rows; k += 4) {
        load_four<Moving>(
            w, k, [&](std::size_t q) { return begin + k + q; }, tile
        );
    }
    if (k < rows) { // short of rows: the last one again, unused
        load_four<Moving>(
            w, k, [&](std::size_t q) { return begin + std::min(k + q, rows - 1); }, tile
        );
    }
}

template <class Spring, class Real>
[[gnu::always_inline]] inline void find_geometry(const SpringConstants& own, std::size_t rows, Tile<Real>& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const double r1 = t.exact_radius_1[k], r2 = t.exact_radius_2[k];
        const Placement<double> at = find_placement(triple(t.branch, k), r1, r2);
        const Real overlap = static_cast<Real>(at.overlap);
        const double stiffness = Spring::secant(own, r1, r2, at.per_reach, static_cast<double>(overlap));
        set(t.normal, k, at.normal);
        t.overlap[k] = overlap;
        t.reach_over_distance[k] = static_cast<Real>(at.reach_over_distance);
        t.normal_stiffness[k] = static_cast<Real>(stiffness);
        t.radius_1[k] = static_cast<Real>(r1);
        t.radius_2[k] = static_cast<Real>(r2);
    }
}

/// Speed at which the grains of a contact part [m/s].
template <class Real>
[[gnu::always_inline]] inline Real opening_at(const Tile<Real>& t, std::size_t k) {
    return dot(triple(t.normal, k), triple(t.velocity, k));
}

/// Of springs that stiffen with the overlap: contacts that part let go of a share of them.
template <class Spring, bool Twisting, class Real>
[[gnu::always_inline]] inline void
let_go(const DomainWork<Real>& w, std::size_t begin, std::size_t rows, const Tile<Real>& t) {
    const MemoryColumns<Real> m = w.memory;
    const SpringConstantsOf<Real> own = w.law.spring_constants;
    const Real dt = w.dt;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        const Real left = left_by_parting<Spring>(own, t.overlap[k], opening_at(t, k), dt);
        m.fx[c] *= left, m.fy[c] *= left, m.fz[c] *= left;
        m.bx[c] *= left, m.by[c] *= left, m.bz[c] *= left;
        if constexpr (Twisting) {
            m.tx[c] *= left, m.ty[c] *= left, m.tz[c] *= left;
        }
    }
}

template <class Real>
[[gnu::always_inline]] inline void
add_viscous_forces(const LawConstantsOf<Real>& law, std::size_t rows, Tile<Real>& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        t.normal_force[k] += viscous_force(law, t.radius_1[k], t.radius_2[k], t.normal_stiffness[k], opening_at(t, k));
    }
}

template <bool Adhesive, bool Twisting, class Real>
[[gnu::always_inline]] inline void
predict_forces(const DomainWork<Real>& w, std::size_t begin, std::size_t rows, Tile<Real>& t) {
    const LawConstantsOf<Real> law = w.law;
    const MemoryColumns<Real> m = w.memory;
    const Real dt = w.dt;
    for (std::size_t k = 0; Adhesive && k < rows; ++k) {
        t.bonded[k] = m.bonded[begin + k];
    }
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        const GrainPair<Real> pair{
            {}, triple(t.velocity, k), triple(t.spin_1, k), triple(t.spin_2, k), t.radius_1[k], t.radius_2[k]};
        ContactMemory<Real> memory{
            {m.fx[c], m.fy[c], m.fz[c]}, {m.bx[c], m.by[c], m.bz[c]}, {}, {m.nx[c], m.ny[c], m.nz[c]}, 0};
        if constexpr (Adhesive) {
            memory.bonded = t.bonded[k];
        }
        if constexpr (Twisting) {
            memory.twisting = {m.tx[c], m.ty[c], m.tz[c]};
        }
        const Limits<Real> limits = predict_forces<Adhesive, Twisting>(law, dt, pair, geometry_at(t, k), memory);
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

/// Puts the scales where the limits were.
template <class Real>
[[gnu::always_inline]] inline void find_scales(std::size_t rows, Tile<Real>& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const Limits<Real> limits{{}, t.slip_limit[k], t.bending_limit[k], {}, {}};
        const Scales<Real> scales = find_scales(limits, triple(t.shear_force, k), triple(t.bending, k));
        t.slip_limit[k] = scales.shear_force;
        t.bending_limit[k] = scales.bending;
    }
}

template <bool Twisting, class Real>
[[gnu::always_inline]] inline void
limit_forces(const MemoryColumns<Real>& columns, std::size_t begin, std::size_t rows, Tile<Real>& t) {
    const MemoryColumns<Real> m = columns;
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        const Limits<Real> limits{t.normal_force[k], {}, {}, Twisting ? t.twisting_limit[k] : Real{}, t.touching[k]};
        const Scales<Real> scales{t.slip_limit[k], t.bending_limit[k]};
        ContactMemory<Real> memory{triple(t.shear_force, k), triple(t.bending, k), {}, {}, 0};
        if constexpr (Twisting) {
            memory.twisting = triple(t.twisting, k);
        }
        const ContactOutcome<Real> out =
            limit_forces<Twisting>(geometry_at(t, k), limits, scales, t.radius_1[k], t.radius_2[k], memory);
        m.fx[c] = memory.shear_force.x, m.fy[c] = memory.shear_force.y, m.fz[c] = memory.shear_force.z;
        m.bx[c] = memory.bending.x, m.by[c] = memory.bending.y, m.bz[c] = memory.bending.z;
        m.nx[c] = memory.normal.x, m.ny[c] = memory.normal.y, m.nz[c] = memory.normal.z;
        if constexpr (Twisting) {
            m.tx[c] = memory.twisting.x, m.ty[c] = memory.twisting.y, m.tz[c] = memory.twisting.z;
        }
        set(t.force(), k, out.force);
        set(t.torque_1(), k, out.torque_1);
        set(t.torque_2(), k, out.torque_2);
    }
}

/// Contacts that only push: what the other parts of the law would leave at zero is left alone, and no step needs to
/// know the normals of the one before.
template <class Real>
[[gnu::always_inline]] inline void push_apart(std::size_t rows, Tile<Real>& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const Push<Real> out = push(geometry_at(t, k));
        t.touching[k] = out.touching;
        set(t.force(), k, out.force);
    }
}

template <class Real>
[[gnu::always_inline]] inline void
keep_overlaps(const MemoryColumns<Real>& m, std::size_t begin, std::size_t rows, const Tile<Real>& t) {
    for (std::size_t k = 0; k < rows; ++k) {
        m.overlap[begin + k] = t.touching[k] > Real{} ? t.overlap[k] : Real{};
    }
}

template <class Real>
[[gnu::always_inline]] inline void
keep_normals(const MemoryColumns<Real>& m, std::size_t begin, std::size_t rows, const Tile<Real>& t) {
    const Real zero{};
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        m.nx[c] = t.touching[k] > zero ? t.normal.x[k] : zero;
        m.ny[c] = t.touching[k] > zero ? t.normal.y[k] : zero;
        m.nz[c] = t.touching[k] > zero ? t.normal.z[k] : zero;
    }
}

template <class Real>
[[gnu::always_inline]] inline void add_stress(
    const Rows3<Real>& force, const Rows3<double>& branch, std::size_t rows, const SumQuantum& quantum,
    double largest_force, StressSum& sum
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

template <bool Turning, class Real>
[[gnu::always_inline]] inline void
add_to_grains(const DomainWork<Real>& w, std::size_t begin, std::size_t rows, Tile<Real>& t) {
    const auto add_four = [&](std::size_t k, std::size_t count) {
        const Double4x4 force = vectors(t.force(), k);
        Double4x4 torque_1, torque_2;
        if constexpr (Turning) {
            torque_1 = vectors(t.torque_1(), k), torque_2 = vectors(t.torque_2(), k);
        }
        for (std::size_t q = 0; q < count; ++q) {
            const std::size_t c = begin + k + q;
            grains::GrainSum& first = w.sums[w.first[c]];
            first.force -= force[q];
            if constexpr (Turning) {
                first.torque += torque_1[q];
            }
            grains::GrainSum& second = w.sums[w.second_sum[c]];
            second.force += force[q];
            if constexpr (Turning) {
                second.torque += torque_2[q];
            }
        }
    };
    std::size_t k = 0;
    for (; k + 4 <= rows; k += 4) {
        add_four(k, 4);
    }
    if (k < rows) {
        add_four(k, rows - k);
    }
}

/// Prefetches the second grain of a contact, and for its sums.
template <class Real>
[[gnu::always_inline]] inline void fetch_second(const DomainWork<Real>& w, std::size_t c) {
    const auto* row = reinterpret_cast<const char*>(&w.grains[w.second[c]]);
    __builtin_prefetch(row);
    __builtin_prefetch(row + sizeof(grains::MovingRow) - 1);
    __builtin_prefetch(&w.sums[w.second_sum[c]], 1);
}

/// `Springs`: contacts have more than a normal force.
template <bool Springs, bool Adhesive, bool Twisting, class Real>
[[gnu::always_inline]] inline void press(const DomainWork<Real>& w, const DomainRows& domain, StressSum& stress) {
    Tile<Real> tile;
    auto far = domain.far.begin();
    for (std::size_t c = domain.begin; c < domain.end; c += tile_rows) {
        const std::size_t rows = std::min(tile_rows, domain.end - c);
        load<Springs>(w, c, rows, tile);
        // The second grains of the tile to come lie all over the table of grains, while the first ones follow each
        // other.
        const std::size_t next = c + rows, next_end = std::min(next + tile_rows, domain.end);
        for (std::size_t k = next; w.beyond_cache && k < next_end; ++k) {
            fetch_second(w, k);
        }
        for (; !w.beyond_cache && far != domain.far.end() && *far < next_end; ++far) {
            fetch_second(w, *far);
        }
        visit_spring(
            w.exact_law.spring,
            [&]<class Spring>(Spring) __attribute__((always_inline)) {
                find_geometry<Spring>(w.exact_law.spring_constants, rows, tile);
                if constexpr (Springs && Spring::stiffens) {
                    let_go<Spring, Twisting>(w, c, rows, tile);
                }
            }
        );
        if constexpr (Springs) {
            predict_forces<Adhesive, Twisting>(w, c, rows, tile);
            if (w.exact_law.viscosity > 0) {
                add_viscous_forces(w.law, rows, tile);
            }
            find_scales(rows, tile);
            limit_forces<Twisting>(w.memory, c, rows, tile);
        } else {
            push_apart(rows, tile);
        }
        if (w.looked_at) {
            keep_overlaps(w.memory, c, rows, tile);
            if constexpr (!Springs) {
                keep_normals(w.memory, c, rows, tile);
            }
        }
        add_stress(tile.force(), tile.branch, rows, w.quantum, w.largest_force, stress);
        add_to_grains<Springs>(w, c, rows, tile);
    }
}

// The loops: for each precision, without and with what a sample may need.
#define SUFFUSE_CONTACT_LOOP(name, springs, adhesive, twisting)                                                        \
    SUFFUSE_CLONES void name(const DomainWork<double>& w, const DomainRows& domain, StressSum& stress) {               \
        press<springs, adhesive, twisting>(w, domain, stress);                                                         \
    }                                                                                                                  \
    SUFFUSE_CLONES void name(const DomainWork<float>& w, const DomainRows& domain, StressSum& stress) {                \
        press<springs, adhesive, twisting>(w, domain, stress);                                                         \
    }

SUFFUSE_CONTACT_LOOP(press_normals, false, false, false)
SUFFUSE_CONTACT_LOOP(press_plain, true, false, false)
SUFFUSE_CONTACT_LOOP(press_twisting, true, false, true)
SUFFUSE_CONTACT_LOOP(press_adhesive, true, true, false)
SUFFUSE_CONTACT_LOOP(press_all, true, true, true)
#undef SUFFUSE_CONTACT_LOOP

} // namespace

template <class Real>
DomainLoop<Real> choose_loop(bool normals_only, bool adhesive, bool twisting) {
    if (normals_only) {
        return press_normals;
    }
    if (adhesive) {
        return twisting ? static_cast<DomainLoop<Real>>(press_all) : static_cast<DomainLoop<Real>>(press_adhesive);
    }
    return twisting ? static_cast<DomainLoop<Real>>(press_twisting) : static_cast<DomainLoop<Real>>(press_plain);
}

template DomainLoop<double> choose_loop(bool, bool, bool);
template DomainLoop<float> choose_loop(bool, bool, bool);

} // namespace suffuse::contact
