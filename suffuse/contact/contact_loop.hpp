#pragma once
// The loop over the contacts of one domain, behind forces.cpp.

#include "suffuse/base/exact_sum.hpp"
#include "suffuse/contact/forces.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace suffuse::contact {

/// The columns that the law reads and writes.
template <class Real>
struct MemoryColumns {
    Real *fx, *fy, *fz, *bx, *by, *bz, *nx, *ny, *nz, *tx, *ty, *tz, *overlap;
    std::uint8_t* bonded;
};

/// What the loop over a domain reads and writes.
template <class Real>
struct DomainWork {
    const grains::MovingRow* grains;
    const std::uint32_t *first, *second, *second_sum;
    const std::uint16_t* image;
    const ImageShift* shifts;
    LawConstants exact_law;
    LawConstantsOf<Real> law;
    Real dt;
    SumQuantum quantum;
    double largest_force; ///< [N]
    bool looked_at;       ///< the table is, after this step
    bool beyond_cache;    ///< there are more grains than a processor's cache holds
    MemoryColumns<Real> memory;
    grains::GrainSum* sums;
};

/// Sums of force (x) branch, in quanta, and whether a force is out of bounds.
struct StressSum {
    std::array<std::uint64_t, 9> quanta{};
    std::uint64_t wild = 0;
};

/// Rows of the contact table.
struct DomainRows {
    std::size_t begin, end;
    std::span<const std::uint32_t> far; ///< of them, those whose second grain may lie in the cache of another core
};

/// Presses the contacts of a domain: updates their memory, adds to the sums of their grains.
template <class Real>
using DomainLoop = void (*)(const DomainWork<Real>&, const DomainRows&, StressSum&);

/// The loop that leaves out what no contact of the sample has. @param normals_only contacts can only push
template <class Real>
DomainLoop<Real> choose_loop(bool normals_only, bool adhesive, bool twisting);

} // namespace suffuse::contact
