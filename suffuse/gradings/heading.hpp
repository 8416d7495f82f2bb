#pragma once
// What the heading of a column says, in English, French, German, Spanish or Italian: whether it holds sizes, shares or
// masses, names of samples, and in which unit.

#include "suffuse/gradings/sieve_size.hpp"

#include <string>
#include <string_view>

namespace suffuse::gradings {

enum class ColumnKind {
    Other,
    Size,
    Share,
    Sample, ///< or the depth it was taken from: rows of one soil have the same
    Tare,   ///< mass of the empty sieve
    Gross,  ///< mass of the sieve and what it retains
};

/// What the numbers of a column of shares count.
enum class ShareMeaning {
    Passing,
    CumulativeRetained,
    OnSieve,
    Retained,   ///< on the sieve alone or with all coarser ones: the numbers decide
    Cumulative, ///< finer or coarser: the numbers decide
    Unstated,   ///< finer, coarser, or on each sieve alone: the numbers decide
};

enum class ShareUnit { Unknown, Percent, Fraction, PerMille, Mass, Count };

struct Heading {
    ColumnKind kind = ColumnKind::Other;
    ShareMeaning meaning = ShareMeaning::Passing;
    ShareUnit unit = ShareUnit::Unknown;
    SizeScale scale = SizeScale::Unknown;
    bool names_depth = false;
    bool is_bare_mass = false;      ///< "Mass (g)": of what the sieve keeps, unless sieves were weighed
    bool names_sieve_alone = false; ///< "std sieve": its name, where another column may have its opening
    bool is_length_alone = false;   ///< "L, cm": nothing but its unit says that it is a size
    bool counts_grains = false;     ///< "finer by number (%)": no share of their mass
    const char* mass_unit = "g";
    std::string own_unit; ///< in brackets, as written
    std::string rest;     ///< the words that say none of this: the name of a sample, as written
};

Heading read_heading(std::string_view text);

/// Small letters of the Latin alphabet alone: accents dropped, everything else a blank.
std::string plain_words(std::string_view text);

/// Likewise, with one blank between words and one at each end.
std::string spaced_words(std::string_view text);

/// The longest part of a heading that is a size, as in "% passing #4" and "Passing 0.075 mm (%)"; empty where it names
/// no share, or no size.
std::string size_among_words(std::string_view text);

} // namespace suffuse::gradings
