#pragma once
// The numbers in the cells of a table: sizes on the scale of their column, shares and masses, with their units, with
// decimal points or commas. What cannot be read is an error.

#include "suffuse/gradings/grading_columns.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <optional>
#include <string>

namespace suffuse::gradings {

/// A size as a row gives it.
struct CellSize {
    double diameter = 0; ///< [m]
    bool has_unit = false;
    SizeSense sense = SizeSense::At;
    double upper = 0; ///< of a class, its coarser bound [m]
};

class TableCells {
public:
    /// Of columns whose scale is judged already. @param mixes_units some sizes have a unit, others none
    TableCells(const Sheet& sheet, const GradingColumns& columns, bool mixes_units, Problems& problems);

    std::optional<CellSize> read_size(const SheetRow& row);

    /// A share [-] or a mass [kg]; without that of the sieve where the column has a tare.
    std::optional<double> read_amount(const SheetRow& row, const ShareColumn& share);

    /// Of an amount without a unit in its heading: a fraction where none is above 1.
    ShareUnit decide_unit(const ShareColumn& share);

    /// Whether something could not be read.
    [[nodiscard]] bool has_failed() const { return has_failed_; }

    void complain(const Place& place, const std::string& what, const std::string& advice);

private:
    bool check_comma(const SheetRow& row, std::size_t column);
    std::optional<double> read_value(const SheetRow& row, std::size_t column, const ShareColumn& share);

    const Sheet& sheet_;
    const GradingColumns& columns_;
    Problems& problems_;
    bool mixes_units_, has_points_ = false, has_failed_ = false;
};

} // namespace suffuse::gradings
