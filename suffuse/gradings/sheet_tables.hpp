#pragma once
// The tables of a sheet: one below the other, each with its own headings; side by side; with titles above and notes
// below; and those whose sieves stand across, which are turned.

#include "suffuse/base/diagnostics.hpp"
#include "suffuse/gradings/derived_values.hpp"
#include "suffuse/gradings/grading_columns.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// Rows below a table, and within it, that are no sieves.
struct TableNotes {
    std::vector<DerivedValue> derived;
    std::vector<SheetRow> others;
};

struct SheetTable {
    Sheet sheet;                           ///< its titles, headings and values
    std::optional<GradingColumns> columns; ///< where they are known: of a turned table
    TableNotes notes;
    std::string name;                      ///< of its sample, from a title; may be empty
    bool is_hydrometer = false;            ///< a title says so: it goes on where sieves end
    std::optional<double> dry;             ///< mass of the whole sample by a title [kg]
    std::optional<Place> unused_mass = {}; ///< a mass in a title that may be that, where none is
    StatedUnit size_unit = {};             ///< by a title or a comment
};

/// At least one.
std::vector<SheetTable> cut_tables(const Sheet& sheet, Problems& problems);

/// One line for the notes of a table, and one for the values derived from its curve.
void remark_on_notes(const TableNotes& notes, Problems& problems);

} // namespace suffuse::gradings
