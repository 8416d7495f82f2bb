#pragma once
// The words by which headings, units, rows, titles and results are recognized, in English, French, German, Spanish,
// Portuguese and Italian: a new word of a laboratory is a word in a table of lexicon.cpp. They are plain: small letters
// without accents (plain_words of heading.hpp).

#include "suffuse/gradings/derived_values.hpp"
#include "suffuse/gradings/heading.hpp"
#include "suffuse/gradings/sheet_values.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::gradings {

/// What a word says in the heading of a column.
enum class Role {
    Size,
    Sieve,
    Number,
    Passing,
    Retained,
    Coarser,
    Cumulative,
    OnOne,
    Percent,
    Fraction,
    Mass,
    Count,
    By,
    Tare,
    And,
    Gross,
    Soil,
    Sample,
    Depth,
    Phi,
    Filler,
};

std::optional<Role> role_of(std::string_view word);

/// What a unit in a heading says: "%", "g". It is in small letters.
ShareUnit share_unit_named(std::string_view unit);

/// Likewise, of a length or another measure of sizes.
SizeScale size_scale_named(std::string_view unit);

/// What is given below a curve: "cu", "gravel".
std::optional<DerivedValue::Kind> result_named(std::string_view word);

/// What words of rows and titles are about.
enum class Topic {
    Pan,
    PanOrNote, ///< of these, ones that begin notes, too
    Total,
    Loss, ///< of what was washed away
    Washing,
    Mass,
    WholeSample,
    OtherMass, ///< not that of the dry sample
    Before,
    Drying,     ///< what was weighed before was wet
    Counted,    ///< grains, not their mass
    NoDiameter, ///< a size that is none
    Index,      ///< of a row, and no share
    Part,       ///< of a report: its number names no soil
    Hydrometer,
    Units,        ///< what a title says of them
    TotalSample,  ///< "% finer total" next to "% finer -#10"
    ResultFiller, ///< next to the name of a result
    AstmSieves,   ///< whose numbers they are
    OtherSieves,  ///< of British Standards or Tyler
    Mesh,
};

/// Whether this is a word of the topic.
bool is_word_of(Topic topic, std::string_view word);

/// Whether one of these, with blanks around each, begins as a word of the topic.
bool mentions(Topic topic, std::string_view words);

/// Letters beyond ASCII stay as they are.
std::string in_small_letters(std::string_view text);

/// What stands between marks, without what is empty.
std::vector<std::string_view> split_words(std::string_view text, std::string_view marks);

/// What stands before a size: a sign, or words with a blank behind them.
struct SizePrefix {
    std::string_view text;
    SizeSense sense;
};

std::span<const SizePrefix> size_prefixes();

/// What stands between the bounds of a range of sizes.
std::span<const std::string_view> range_marks();

/// The words of one meaning, for docs/gradings.md.
struct WordList {
    std::string_view meaning;
    std::vector<std::string> words; ///< in the order of the tables
};

std::vector<WordList> word_lists();

} // namespace suffuse::gradings
