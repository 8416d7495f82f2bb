#pragma once
// What stands in place of a size: a pan or a total, or a size with a word of what it bounds, as in "< 0.063", "> 63",
// "passing No. 200" and "63 - 31.5".

#include <string>
#include <string_view>

namespace suffuse::gradings {

/// What a row is that is no sieve, by the words in place of its size.
enum class RowWord { None, Pan, Total };

/// The pan holds what passed the finest sieve; so does what was washed away.
RowWord read_row_word(std::string_view text);

/// Which grains a cell of sizes speaks of.
enum class SizeSense {
    At,      ///< 0.063: of the sieve itself
    Finer,   ///< < 0.063, passing No. 200, 0 - 0.063
    Coarser, ///< > 63, retained on No. 4
    Class,   ///< 63 - 31.5: between two sieves, of which the finer keeps them
};

struct SizeText {
    std::string text; ///< of the size alone
    SizeSense sense = SizeSense::At;
    std::string upper = {}; ///< of a class, its coarser bound
};

SizeText split_size_text(std::string_view text);

} // namespace suffuse::gradings
