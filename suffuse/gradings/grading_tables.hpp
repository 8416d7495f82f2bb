#pragma once
// The curves of all tables of a sheet: each table's rows read, and tables that go on with a curve joined to it.

#include "suffuse/gradings/derived_values.hpp"
#include "suffuse/gradings/grading_curve.hpp"
#include "suffuse/gradings/grading_rows.hpp"
#include "suffuse/gradings/reading_options.hpp"
#include "suffuse/gradings/sheet_tables.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// The points of a soil in the order of its rows, and what its sheet says was read off the curve.
struct SoilPoints {
    std::string name;   ///< empty where the file has one soil alone
    std::string sample; ///< its name there, too
    std::vector<GradingPoint> points;
    std::vector<DerivedValue> derived;
    SheetReading reading;
};

/// Of tables whose columns are known. Empty where something is wrong, all of which is reported.
std::optional<std::vector<SoilPoints>> read_tables(std::vector<SheetTable>& tables, Problems& problems);

/// The points of the soils of one table or file, with what its notes say of them.
std::optional<std::vector<SoilPoints>>
points_of(std::vector<SievedSoil> soils, const TableNotes& notes, Problems& problems);

} // namespace suffuse::gradings
