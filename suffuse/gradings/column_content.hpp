#pragma once
// What the numbers of a column of shares or masses can be, whatever its heading says: they rise or fall with the size,
// add up to the whole sample, and agree with the pan. All rules by which numbers decide are here.

#include "suffuse/gradings/grading_columns.hpp"

#include <optional>
#include <vector>

namespace suffuse::gradings {

/// The numbers of one soil in one unit.
struct Amounts {
    std::vector<double> on_sieves; ///< the coarsest first
    std::optional<double> pan, total;
    double whole = 1; ///< of shares: 100 or 1; 0 for masses, whose whole is not known
};

/// Each reading that all the numbers satisfy.
struct PossibleMeanings {
    bool passing = false, cumulative_retained = false, on_sieve = false;
    bool adds_up = false; ///< each sieve's own, with the pan, add up to the whole
};

PossibleMeanings find_possible_meanings(const Amounts& amounts);

/// The readings that two columns of one table share.
PossibleMeanings in_common(const PossibleMeanings& a, const PossibleMeanings& b);

/// The one reading that the name of a column and its numbers leave; empty where there are none or several.
/// @param named by its heading
std::optional<ShareMeaning> choose_meaning(ShareMeaning named, const PossibleMeanings& possible);

/// Whether the numbers decide what a column of this name means.
bool is_open(ShareMeaning named);

/// The numbers of a column in the rows from `first_row` on; empty where a cell is no size or no share from 0 to 100.
std::optional<Amounts>
amounts_in(const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t column);

/// Whether numbers may be shares of a soil: they rise or fall with the size throughout, or add up to the whole.
bool may_be_shares(const PossibleMeanings& possible);

/// Whether one column holds each sieve's own share and the other the same shares added up.
bool are_differences(const Amounts& own, const Amounts& cumulative);

} // namespace suffuse::gradings
