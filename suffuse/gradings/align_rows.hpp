#pragma once
// Tables in which a column is what stands below each other: a row with fewer cells than others has them where they
// stand in its line, not from the first column on.

#include "suffuse/gradings/sheet.hpp"

namespace suffuse::gradings {

/// Gives each row of a block of lines the columns of its longest ones. Rows of one cell, and those whose cells fit no
/// columns, stay as they are.
void align_rows(Sheet& sheet);

} // namespace suffuse::gradings
