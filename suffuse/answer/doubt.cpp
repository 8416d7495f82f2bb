#include "suffuse/answer/doubt.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace suffuse::answer {

std::vector<std::string> largest_of(std::vector<Doubt> doubts) {
    constexpr std::size_t most_reported = 3;
    std::ranges::stable_sort(doubts, std::greater(), &Doubt::weight);
    doubts.resize(std::min(doubts.size(), most_reported));
    std::vector<std::string> sentences;
    std::ranges::transform(doubts, std::back_inserter(sentences), &Doubt::sentence);
    return sentences;
}

} // namespace suffuse::answer
