#pragma once
// What makes an answer doubtful.

#include <string>
#include <vector>

namespace suffuse::answer {

struct Doubt {
    double weight = 0; ///< 1 where it begins to matter
    std::string sentence;
};

/// Sentences of at most three, the largest first.
std::vector<std::string> largest_of(std::vector<Doubt> doubts);

} // namespace suffuse::answer
