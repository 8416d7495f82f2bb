#pragma once
// Which columns of shares speak of which soil: by their headings, or by the rows above these, where a name may stand
// over several columns; and which one is read where a soil has several.

#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace suffuse::gradings {

struct SoilColumns {
    std::string name;                 ///< empty where there is one soil alone
    std::vector<std::size_t> columns; ///< of the sheet; more than one where the sheet leaves open which is meant
};

/// Soils in the order of their columns. @param columns of one meaning, rising
/// @param header_row of the headings, from which on the rows above count; @param first_row of the values
std::vector<SoilColumns> find_soil_columns(
    const Sheet& sheet, const std::vector<Heading>& headings, const std::vector<std::size_t>& columns,
    std::size_t header_row, std::size_t first_row
);

} // namespace suffuse::gradings
