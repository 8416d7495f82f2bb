#pragma once
// Columns whose fresh rows are left unset: the parallel loop that fills one is the first to touch its memory. Touched
// by one thread, fresh memory takes it longer than much of what all of them then write there. Long ones lie in large
// pages where the system has them: rows are read in whatever order neighbors come.

#include "suffuse/base/large_pages.hpp"

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace suffuse {

template <class T>
struct LeaveUnset : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T>, "a row that nobody has set must be no harm");

    LeaveUnset() = default;

    template <class U>
    explicit LeaveUnset(const LeaveUnset<U>&) noexcept {}

    template <class U>
    struct rebind {
        using other = LeaveUnset<U>;
    };

    T* allocate(std::size_t rows) {
        T* const begin = std::allocator<T>::allocate(rows);
        advise_large_pages(begin, rows * sizeof(T));
        return begin;
    }

    template <class U>
    void construct(U*) noexcept {} // a row that is given no value

    template <class U, class... Values>
    void construct(U* row, Values&&... values) {
        std::construct_at(row, std::forward<Values>(values)...);
    }
};

/// To be filled by the loop that follows where it is resized.
template <class T>
using RawColumn = std::vector<T, LeaveUnset<T>>;

} // namespace suffuse
