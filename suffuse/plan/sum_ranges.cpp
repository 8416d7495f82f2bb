#include "suffuse/plan/sum_ranges.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::plan {

Range sum_ranges(const std::vector<Range>& parts) {
    constexpr double least_share = 0.1; // of the most, where a part may cost nothing at all
    const double common_error = std::log(1.3);
    Range ends, widest;
    double sum = 0, common = 0, own_squares = 0;
    for (const Range& part : parts) {
        if (!(part.most > 0)) {
            continue;
        }
        ends += part;
        widest = part.most > widest.most ? part : widest;
        const double least = std::max(part.least, least_share * part.most);
        const double size = std::sqrt(least * part.most), error = 0.5 * std::log(part.most / least);
        const double shared = std::min(error, common_error);
        sum += size;
        common += size * shared;
        own_squares += size * size * (error * error - shared * shared);
    }
    if (ends.most <= widest.most) {
        return widest; // the only part
    }
    const double factor = std::exp(std::sqrt(own_squares + common * common) / sum);
    return {std::max(sum / factor, ends.least), std::min(sum * factor, ends.most)};
}

} // namespace suffuse::plan
