#pragma once
// Sums over the contacts that touch, on all threads. Blocks are cut by the first grain, so that neither the number of
// threads nor which near neighbors are listed changes a bit.

#include "suffuse/base/parallel.hpp"
#include "suffuse/contact/contacts.hpp"

#include <algorithm>
#include <utility>

namespace suffuse::contact {

/// First row of the table whose first grain is `grain` or a later one.
inline std::size_t first_row_of(const ContactPairs& contacts, std::size_t grain) {
    return static_cast<std::size_t>(std::ranges::lower_bound(contacts.first, grain) - contacts.first.begin());
}

/// Calls `body(sum, c)` for each contact that touches, in the order of the table within blocks of grains, whose sums
/// are then added in order. @param grains of the sample
template <class Real, class T, class Body>
T sum_touching(const ContactPairs& contacts, const MemoryOf<Real>& memory, std::size_t grains, T zero, Body&& body) {
    constexpr std::size_t block = 1024;
    return parallel_sum(grains, block, zero, [&](std::size_t begin, std::size_t end) {
        T sum = zero;
        const std::size_t last = first_row_of(contacts, end);
        for (std::size_t c = first_row_of(contacts, begin); c < last; ++c) {
            if (memory.touches(c)) {
                body(sum, c);
            }
        }
        return sum;
    });
}

template <class T, class Body>
T sum_touching(const Contacts& contacts, std::size_t grains, T zero, Body&& body) {
    return sum_touching(contacts, contacts, grains, zero, std::forward<Body>(body));
}

} // namespace suffuse::contact
