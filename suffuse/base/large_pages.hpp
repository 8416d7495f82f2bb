#pragma once
// Memory for long columns that are made and freed again and again. The system hands memory out page by page when it is
// first touched: of small pages that takes longer than much of what is then written there.

#include <cstddef>

namespace suffuse {

/// Asks the system for large pages from `begin` on, where it has them; nothing changes but the time that it takes.
void advise_large_pages(void* begin, std::size_t bytes);

/// Room for `rows` values; an empty column has it in large pages where that is much.
template <class Column>
void reserve_in_large_pages(Column& column, std::size_t rows) {
    if (column.capacity() < rows) {
        column.reserve(rows);
        advise_large_pages(column.data(), rows * sizeof(column[0]));
    }
}

} // namespace suffuse
