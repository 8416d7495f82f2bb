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

} // namespace suffuse::atlas
