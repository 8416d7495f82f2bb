#pragma once
// The pairs of grains that overlap in a cell, with checks of what makes no sense to look for.

#include "suffuse/grains/grains.hpp"
#include "suffuse/neighbors/pairs.hpp"

#include <optional>
#include <string>
#include <vector>

namespace suffuse::io {

struct Overlap {
    neighbors::Pair pair;
    double share = 0; ///< of the smaller radius [-]
};

/// What is wrong with grains that do not fit into their cell: a mistake of units, most often. Nothing where they do.
std::optional<std::string> size_complaint(const grains::Grains& grains, const Mat3& h);

/// All pairs that overlap, in the order of neighbors::find_pairs.
/// @param origin the file, for messages
/// @throws CaseError where grains are too large or too many for the cell, or lie too far from it.
std::vector<Overlap> find_overlaps(const grains::Grains& grains, const Mat3& h, const std::string& origin);

/// Two grains in one place have no normal, however much overlap is allowed. @throws CaseError, naming them.
void check_apart(const grains::Grains& grains, const std::vector<Overlap>& overlaps, const std::string& origin);

/// "grains 3 and 7", "grain 3 and its own image".
std::string names_of(const grains::Grains& grains, const neighbors::Pair& pair);

} // namespace suffuse::io
