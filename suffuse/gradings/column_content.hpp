#pragma once
// What the numbers of a column can be, whatever its heading says: sizes on a scale; shares or masses that rise or fall
// with the size, add up to the whole sample, and agree with the pan. All rules by which numbers decide are here.

#include "suffuse/gradings/grading_columns.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace suffuse::gradings {

/// What plain numbers in a column of sizes mean where its heading does not say.
struct PlainSizes {
    SizeScale scale = SizeScale::Unknown;
    bool has_plain = false; ///< sizes without a unit
    bool mix_units = false; ///< some sizes have a unit other than mm and others none, under a heading that does not say
};

/// Sieve numbers where the sizes rise and fall as they should only that way.
PlainSizes judge_plain_sizes(const Sheet& sheet, const GradingColumns& columns);

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

/// Whether a column names the soils of a table: its values are constant within blocks of rows, and the sizes of each
/// block go over much the same range.
bool names_soils(const Sheet& sheet, std::size_t first_row, const SizeColumn& size, std::size_t column);

/// Whether they rise or fall with the size throughout.
bool is_cumulative(const Amounts& amounts);

/// Which of some columns may be shares. Of two, one of which is the other added up, only that one.
std::vector<std::pair<std::size_t, Amounts>> find_share_columns(
    const Sheet& sheet, std::size_t first_row, const SizeColumn& size, const std::vector<std::size_t>& candidates
);

/// Of two columns of sizes, of which one is finer in each row, that one: they bound classes.
std::optional<std::size_t> find_finer_bound(const Sheet& sheet, std::size_t first_row, std::size_t a, std::size_t b);

/// Two columns of numbers, of which one can be the sizes alone; else an error.
std::optional<GradingColumns> find_unnamed_columns(const Sheet& sheet, Problems& problems);

} // namespace suffuse::gradings
