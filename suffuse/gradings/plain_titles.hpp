#pragma once
// Names of soils that stand above their tables without a word for what they are: "TP1", "Soil A".

#include "suffuse/gradings/sheet_tables.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace suffuse::gradings {

/// "TP2" right above the headings: one cell, with a number or a letter of its own, that says nothing else. Empty where
/// there is none.
std::string plain_name_above(const Sheet& sheet, std::size_t first, std::size_t header);

/// Tables below each other that all have such a title, each another one, are soils of these names.
void take_plain_names(const std::vector<std::string>& titles, std::vector<SheetTable>& tables);

} // namespace suffuse::gradings
