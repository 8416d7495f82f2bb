#include "suffuse/atlas/value.hpp"

#include <cmath>

namespace suffuse::atlas {

Value over_seeds(const std::vector<double>& samples) {
    Value value;
    for (const double sample : samples) {
        value.mean += sample / static_cast<double>(samples.size());
    }
    if (samples.size() > 1) {
        double squares = 0;
        for (const double sample : samples) {
            squares += (sample - value.mean) * (sample - value.mean);
        }
        value.deviation = std::sqrt(squares / static_cast<double>(samples.size() - 1));
    }
    return value;
}

void add_weighted(std::optional<double>& sum, const std::optional<double>& deviation, double weight, bool counts) {
    if (counts && !deviation) {
        sum.reset();
    } else if (sum) {
        *sum += weight * deviation.value_or(0);
    }
}

} // namespace suffuse::atlas
