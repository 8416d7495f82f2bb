#include "apps/explain_word.hpp"

#include "suffuse/base/spelling.hpp"
#include "suffuse/casefile/explain.hpp"
#include "suffuse/report/figure_guide.hpp"
#include "suffuse/stability/criterion_guide.hpp"

#include <fmt/format.h>

#include "apps/command_line.hpp"

namespace suffuse::apps {

std::string explain_word(const std::string& word) {
    if (const auto text = casefile::explain(word)) {
        return *text;
    }
    if (const auto text = report::explain_figure(word)) {
        return *text;
    }
    if (const auto text = stability::explain_criterion(word)) {
        return *text;
    }
    auto nearest = nearest_word(word, explained_words());
    if (!nearest) {
        nearest = casefile::nearest_key(word);
    }
    throw UsageError(fmt::format(
        "nothing is known about {}; {}", shown(word),
        nearest ? fmt::format("a similar word: suffuse explain {}", *nearest)
                : "suffuse schema lists all keys of a case; its tables (contact), verbs (erode), codes (E310), figures "
                  "(figure-9) and criteria (kezdi-1979) are known too"
    ));
}

std::vector<std::string> explained_words() {
    std::vector<std::string> words = casefile::topics();
    for (const auto& more : {report::figure_names(), stability::criterion_ids()}) {
        words.insert(words.end(), more.begin(), more.end());
    }
    return words;
}

} // namespace suffuse::apps
