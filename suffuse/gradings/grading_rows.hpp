#pragma once
// The values of a table, soil by soil: which rows are sieves, which the pan, a total or a sieve that was not used. A
// remark names what is skipped; what cannot be read is an error.

#include "suffuse/gradings/grading_columns.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// What one sieve says of one soil, as written.
struct SieveRow {
    double diameter = 0; ///< [m]
    double amount = 0;   ///< share [-] or mass [kg]
    Place diameter_place, amount_place;
    bool has_unit = false; ///< of the size: at it or in the heading
    bool is_bound = false; ///< "< 0.063" or 0: the pan, unless it is a size that grains pass
    double upper = 0;      ///< of a class, its coarser bound [m]
};

/// A size without a value.
struct BlankSize {
    double diameter = 0; ///< [m]
    Place place;
};

/// A line `Fines` in a column of masses: a mass that passed the finest sieve, or a result in percent.
struct FinesLine {
    double number = 0, unit = 0; ///< as written, and of that number [kg]
    bool is_mass = false;        ///< by its name
    std::string name;
    Place place;
};

struct SievedSoil {
    std::string name;
    ShareMeaning meaning = ShareMeaning::Passing;
    ShareUnit unit = ShareUnit::Percent;
    std::vector<SieveRow> sieves;     ///< in the order of the sheet
    std::optional<double> pan, total; ///< as the sieves' amounts
    std::string heading;              ///< of its column
    Place heading_place, end;
    std::size_t column = 0;    ///< of the sheet, from 0
    std::optional<double> dry; ///< mass of the whole sample, stated above the table [kg]
    double lost = 0;           ///< in sieving, as the sieves' amounts
    std::optional<FinesLine> fines;
    const char* mass_unit = "g";
    std::string size_heading, size_unit = "mm";
    bool is_by_number = false;     ///< shares of the number of grains, not of their mass
    bool is_of_largest = false;    ///< masses without a pan or total are shares of the largest
    std::vector<BlankSize> blanks; ///< where a heading says nothing: they may bound classes
};

/// Empty where something is wrong, all of which is reported.
std::optional<std::vector<SievedSoil>> read_sieve_rows(const Sheet& sheet, GradingColumns columns, Problems& problems);

} // namespace suffuse::gradings
