#pragma once
// One finding of the paper and how this run stands to it: the paper's words, the criterion that stands for them, which
// numbers of that criterion are ours, the verdict, and the reason for it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suffuse::study {

/// Nothing where a run cannot decide.
using Verdict = std::optional<bool>;

/// A claim of two parts: false as soon as one part is, true only when both are known to be.
inline Verdict both(Verdict first, Verdict second) {
    if (first == false || second == false) {
        return false;
    }
    return first && second ? Verdict(true) : std::nullopt;
}

struct Finding {
    std::string id;    ///< "E1" to "E7", "M1" to "M9"
    std::string claim; ///< the criterion, in words
    std::string paper; ///< what the paper reports, in its words
    std::string ours;  ///< what this run found, with numbers
    Verdict met;

    std::vector<std::string> our_numbers = {}; ///< parts of `claim` that the paper does not give
    Verdict in_words = std::nullopt; ///< whether the paper's words hold without them; nothing where that is not needed
    bool is_noise = false;           ///< what would meet it is noise of the balance, not the water's doing
    bool seeds_disagree = false;     ///< some seeds meet it and others do not
    std::string why = {};            ///< the reason, a sentence or two; empty where it is plainly met
};

/// How a finding stands, for the reader.
enum class Standing { Met, MetByNoise, NotMet, NotMetByOurNumber, SeedsDisagree, Undecided };

Standing standing_of(const Finding& finding);

/// "met", "met by noise", "not met", "not met by our number", "seeds disagree", "cannot tell".
std::string_view name_of(Standing standing);

/// Whether the run agrees with the paper: agreement by noise is none, and cannot be decided.
Verdict agreement_of(const Finding& finding);

/// "2 and 10 %": the numbers of ours in a row; empty where there is none.
std::string list_our_numbers(const Finding& finding);

/// "1 of 7 met; 3 met by noise; 1 not met by our number; 2 not met": those that there are.
std::string count_standings(const std::vector<Finding>& findings);

/// The reason as reported in a row of findings: "As E4." where one before has the same.
std::string reason_in_table(const std::vector<Finding>& findings, std::size_t at);

/// One finding for the same case run with several seeds: where they disagree, the criterion cannot be decided.
std::vector<Finding> combine_seeds(const std::vector<std::vector<Finding>>& by_seed);

} // namespace suffuse::study
