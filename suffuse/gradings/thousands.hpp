#pragma once
// Marks between thousands: "1,250" is 1250 or 1.25. Other numbers of the sheet decide (0.5, 12,75, 1,250,000); in a
// table of sieves also the order of the sizes, totals, a dry mass and empty sieves. What nothing decides is an error.

#include "suffuse/gradings/sheet.hpp"
#include "suffuse/gradings/sheet_tables.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// The decimal sign that the numbers of a sheet show by themselves; 0 where none do, or they contradict one another.
char find_decimal_sign(const Sheet& sheet);

/// The first number in a column that has marks before three digits each, where its other numbers are whole.
struct GroupedNumber {
    SheetCell cell;
    char mark = ',';
    bool has_plain = false; ///< some other number of the column has no mark, and is not 0

    [[nodiscard]] double value(bool is_thousands) const;
    [[nodiscard]] std::string plain(bool is_thousands) const; ///< "1250", "1.25"
};

std::optional<GroupedNumber> find_grouped(const Sheet& sheet, std::size_t first_row, std::size_t column);

/// Takes the marks between thousands out of the numbers of a column.
void join_groups(Sheet& sheet, std::size_t first_row, std::size_t column, char mark);

/// Takes the marks out of numbers that can be read in one way alone: "20 000", "1,000.5" and "1.000,5".
void join_sure_groups(Sheet& sheet);

/// Joins the thousands of the columns of all tables, with a remark, and reports those that nothing decides.
void settle_thousands(const Sheet& sheet, std::vector<SheetTable>& tables, Problems& problems);

} // namespace suffuse::gradings
