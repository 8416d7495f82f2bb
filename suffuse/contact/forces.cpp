#include "suffuse/contact/forces.hpp"

#include "suffuse/base/clones.hpp"
#include "suffuse/base/exact_sum.hpp"
#include "suffuse/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace suffuse::contact {
namespace {

constexpr std::size_t tile_rows = 64;
constexpr std::size_t lanes =
    8; // of the stress sum, whatever the vector width: the order of the sum is part of the result

using Row = std::array<double, tile_rows>;

struct alignas(64) Rows3 {
    Row x, y, z;
};

/// The two grains of each contact of a tile, side by side.
struct alignas(64) Tile {
    Rows3 branch, velocity, spin_1, spin_2;
    Row radius_1, radius_2, bonded;
    Rows3 force, torque_1, torque_2;
};

void set(Rows3& rows, std::size_t k, const Vec3& v) {
    rows.x[k] = v.x, rows.y[k] = v.y, rows.z[k] = v.z;
}

Vec3 get(const Rows3& rows, std::size_t k) {
    return {rows.x[k], rows.y[k], rows.z[k]};
}

Triple<double> triple(const Rows3& rows, std::size_t k) {
    return {rows.x[k], rows.y[k], rows.z[k]};
}

void load(
    const grains::Grains& grains, const Contacts& contacts, const Mat3& h, const Mat3& image_velocity,
    std::size_t begin, std::size_t rows, Tile& tile
) {
    for (std::size_t k = 0; k < rows; ++k) {
        const std::size_t c = begin + k;
        const std::uint32_t i = contacts.first[c], j = contacts.second[c];
        Vec3 branch = grains.position[j] - grains.position[i];
        Vec3 velocity = grains.velocity[j] - grains.velocity[i];
        if (const cell::Image& image = contacts.image[c]; image != cell::Image{}) {
            branch += cell::shift(h, image);
            velocity += cell::shift(image_velocity, image);
        }
        set(tile.branch, k, branch);
        set(tile.velocity, k, velocity);
        set(tile.spin_1, k, grains.spin[i]);
        set(tile.spin_2, k, grains.spin[j]);
        tile.radius_1[k] = grains.radius[i];
        tile.radius_2[k] = grains.radius[j];
    }
}

/// The columns that the law reads and writes, offset to the tile's first row.
struct MemoryPointers {
    double *fx, *fy, *fz, *bx, *by, *bz, *nx, *ny, *nz, *tx, *ty, *tz, *overlap;
};

template <bool Adhesive, bool Twisting>
[[gnu::always_inline]] inline void
apply_law(const LawConstants& law, double dt, std::size_t rows, const MemoryPointers& m, Tile& t) {
#pragma GCC ivdep
    for (std::size_t k = 0; k < rows; ++k) {
        const GrainPair<double> pair{triple(t.branch, k), triple(t.velocity, k), triple(t.spin_1, k),
                                     triple(t.spin_2, k), t.radius_1[k],         t.radius_2[k]};
        ContactMemory<double> memory{
            {m.fx[k], m.fy[k], m.fz[k]}, {m.bx[k], m.by[k], m.bz[k]}, {}, {m.nx[k], m.ny[k], m.nz[k]}, 0};
        if constexpr (Adhesive) {
            memory.bonded = t.bonded[k];
        }
        if constexpr (Twisting) {
            memory.twisting = {m.tx[k], m.ty[k], m.tz[k]};
        }
        const ContactOutcome<double> out = linear_rolling<Adhesive, Twisting>(law, dt, pair, memory);
        m.fx[k] = memory.shear_force.x, m.fy[k] = memory.shear_force.y, m.fz[k] = memory.shear_force.z;
        m.bx[k] = memory.bending.x, m.by[k] = memory.bending.y, m.bz[k] = memory.bending.z;
        m.nx[k] = memory.normal.x, m.ny[k] = memory.normal.y, m.nz[k] = memory.normal.z;
        m.overlap[k] = out.overlap;
        if constexpr (Adhesive) {
            t.bonded[k] = memory.bonded;
        }
        if constexpr (Twisting) {
            m.tx[k] = memory.twisting.x, m.ty[k] = memory.twisting.y, m.tz[k] = memory.twisting.z;
        }
        t.force.x[k] = out.force.x, t.force.y[k] = out.force.y, t.force.z[k] = out.force.z;
        t.torque_1.x[k] = out.torque_1.x, t.torque_1.y[k] = out.torque_1.y, t.torque_1.z[k] = out.torque_1.z;
        t.torque_2.x[k] = out.torque_2.x, t.torque_2.y[k] = out.torque_2.y, t.torque_2.z[k] = out.torque_2.z;
    }
}

SUFFUSE_CLONES void
apply_plain(const LawConstants& law, double dt, std::size_t rows, const MemoryPointers& m, Tile& t) {
    apply_law<false, false>(law, dt, rows, m, t);
}

SUFFUSE_CLONES void
apply_twisting(const LawConstants& law, double dt, std::size_t rows, const MemoryPointers& m, Tile& t) {
    apply_law<false, true>(law, dt, rows, m, t);
}

SUFFUSE_CLONES void
apply_adhesive(const LawConstants& law, double dt, std::size_t rows, const MemoryPointers& m, Tile& t) {
    apply_law<true, false>(law, dt, rows, m, t);
}

SUFFUSE_CLONES void apply_all(const LawConstants& law, double dt, std::size_t rows, const MemoryPointers& m, Tile& t) {
    apply_law<true, true>(law, dt, rows, m, t);
}

/// Sums of force (x) branch, exact in two parts and `lanes` side by side.
struct StressSum {
    std::array<double, 9 * lanes> coarse{}, fine{};
};

SUFFUSE_CLONES void add_stress(const Tile& t, std::size_t rows, const SumQuanta& quanta, StressSum& sum) {
    const std::array<const Row*, 3> force{&t.force.x, &t.force.y, &t.force.z};
    const std::array<const Row*, 3> branch{&t.branch.x, &t.branch.y, &t.branch.z};
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            double* coarse = &sum.coarse[(3 * a + b) * lanes];
            double* fine = &sum.fine[(3 * a + b) * lanes];
            for (std::size_t k = 0; k < rows; k += lanes) {
                for (std::size_t l = 0; l < lanes; ++l) {
                    add_exactly(quanta, (*force[a])[k + l] * (*branch[b])[k + l], coarse[l], fine[l]);
                }
            }
        }
    }
}

Mat3 across_lanes(const std::array<double, 9 * lanes>& sum) {
    Mat3 total{};
    for (std::size_t q = 0; q < 9; ++q) {
        for (std::size_t l = 0; l < lanes; ++l) {
            total.m[q / 3][q % 3] += sum[q * lanes + l];
        }
    }
    return total;
}

MemoryPointers memory_at(Contacts& c, std::size_t row, bool twisting) {
    const auto at = [&](std::vector<double>& column) { return column.data() + row; };
    MemoryPointers m{at(c.shear_force.x),
                     at(c.shear_force.y),
                     at(c.shear_force.z),
                     at(c.bending.x),
                     at(c.bending.y),
                     at(c.bending.z),
                     at(c.normal.x),
                     at(c.normal.y),
                     at(c.normal.z),
                     nullptr,
                     nullptr,
                     nullptr,
                     at(c.overlap)};
    if (twisting) {
        m.tx = at(c.twisting.x), m.ty = at(c.twisting.y), m.tz = at(c.twisting.z);
    }
    return m;
}

void apply(const LawConstants& law, double dt, std::size_t begin, std::size_t rows, Contacts& contacts, Tile& tile) {
    const bool adhesive = !contacts.bonded.empty(), twisting = contacts.twisting.size() > 0;
    const MemoryPointers memory = memory_at(contacts, begin, twisting);
    if (adhesive) {
        std::copy_n(contacts.bonded.begin() + static_cast<std::ptrdiff_t>(begin), rows, tile.bonded.begin());
    }
    const auto kernel = adhesive ? (twisting ? apply_all : apply_adhesive) : (twisting ? apply_twisting : apply_plain);
    kernel(law, dt, rows, memory, tile);
    for (std::size_t k = 0; adhesive && k < rows; ++k) {
        contacts.bonded[begin + k] = static_cast<std::uint8_t>(tile.bonded[k]);
    }
}

} // namespace

void index_contacts(const Contacts& contacts, std::size_t grains, Incidence& incidence) {
    incidence.first_start.assign(grains + 1, 0);
    incidence.second_start.assign(grains + 1, 0);
    incidence.second_contact.resize(contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        ++incidence.first_start[contacts.first[c] + 1];
        ++incidence.second_start[contacts.second[c] + 1];
    }
    for (std::size_t g = 0; g < grains; ++g) {
        incidence.first_start[g + 1] += incidence.first_start[g];
        incidence.second_start[g + 1] += incidence.second_start[g];
    }
    std::vector<std::uint32_t> next(incidence.second_start.begin(), incidence.second_start.end() - 1);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
        incidence.second_contact[next[contacts.second[c]]++] = static_cast<std::uint32_t>(c);
    }
}

Mat3 compute_forces(
    const grains::Grains& grains, const Mat3& h, const Mat3& image_velocity, const LawConstants& law, double dt,
    Contacts& contacts, std::vector<ContactForce>& forces
) {
    struct Parts {
        Mat3 coarse, fine;
    };

    forces.resize(contacts.size());
    // No stress reaches the modulus. The quanta follow from the state alone, as the same bits after a resume ask for.
    const SumQuanta quanta(law.twice_modulus * std::abs(determinant(h)));
    constexpr std::size_t block_rows = 8 * tile_rows;
    const Parts sum = parallel_sum(
        contacts.size(), block_rows, Parts{},
        [&](std::size_t begin, std::size_t end) {
            Tile tile;
            StressSum stress;
            for (std::size_t c = begin; c < end; c += tile_rows) {
                const std::size_t rows = std::min(tile_rows, end - c);
                load(grains, contacts, h, image_velocity, c, rows, tile);
                apply(law, dt, c, rows, contacts, tile);
                for (std::size_t k = 0; k < rows; ++k) {
                    forces[c + k] = {get(tile.force, k), get(tile.torque_1, k), get(tile.torque_2, k)};
                }
                for (std::size_t k = rows; k % lanes != 0; ++k) { // the last lanes of a short tile add nothing
                    set(tile.force, k, {});
                    set(tile.branch, k, {});
                }
                add_stress(tile, rows, quanta, stress);
            }
            return Parts{across_lanes(stress.coarse), across_lanes(stress.fine)};
        },
        [](const Parts& a, const Parts& b) {
            return Parts{a.coarse + b.coarse, a.fine + b.fine};
        }
    );
    return sum.coarse + sum.fine;
}

} // namespace suffuse::contact
