#pragma once
// Where the forces of a contact are added up. Grains are cut into domains of fixed size along their storage order; the
// contacts whose first grain lies in a domain are its rows of the table. A domain adds directly to its own grains; what
// it exerts on a grain of another goes into a row of its own, which that grain's domain collects later, in the order of
// the table. So domains run on any threads at the same time, and every sum has one order.

#include "suffuse/contact/contacts.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace suffuse::contact {

/// Grains of a domain, in samples of any size: as few as leave work for 64 threads from 65,536 grains on, and as a
/// processor's second cache holds.
constexpr std::size_t domain_grains = 1024;

/// So many stay in the cache next to a core, about 160 bytes each.
constexpr std::size_t cached_grains = 20'000;

struct SumPlan {
    std::size_t grains = 0;
    std::vector<std::uint32_t> domain_start; ///< first contact row of each domain, and the end
    std::vector<std::uint32_t> second_sum;   ///< for each contact, the row of the sums for its second grain's share
    std::vector<std::uint32_t> remote;       ///< for each row of the sums beyond those of the grains, its grain: a
                                             ///< domain's follow each other, in the order in which it collects them
    std::vector<std::uint32_t> remote_start; ///< first of each domain's, and the end
    std::vector<std::uint32_t> reach;        ///< the domains whose grains each domain's contacts reach, its own too
    std::vector<std::uint32_t> reach_start;  ///< first of each domain's, and the end
    std::vector<std::uint32_t> reached_by;   ///< for each domain, how many reach it
    std::vector<std::uint32_t> roster;       ///< the grains of each domain, those awake first: of some row of the table
    std::vector<std::uint32_t> awake_end;    ///< for each domain, the end of those first ones
    std::vector<std::vector<std::uint32_t>> far; ///< for each domain, its contacts whose second grain lies in the
                                                 ///< domain of another thread, as the threads are when the plan is
                                                 ///< made; empty where there are more than `cached_grains`
    std::vector<std::uint16_t> image;            ///< for each contact, its row of `images`
    std::vector<cell::Image> images;             ///< those that occur

    [[nodiscard]] std::size_t domains() const { return domain_start.size() - 1; }

    [[nodiscard]] std::size_t rows() const { return grains + remote.size(); } ///< of the sums
};

/// Makes the plan of a sorted table. @param awake a 1 for each grain that is awake though it may be in no row; or empty
/// @throws StateError where more than 65,535 different images occur: grains have drifted over that many periods.
void plan_sums(
    const ContactPairs& contacts, std::size_t grains, SumPlan& plan, std::span<const std::uint8_t> awake = {}
);

} // namespace suffuse::contact
