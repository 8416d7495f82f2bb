#include "suffuse/job/sample_fit.hpp"

#include <algorithm>
#include <cmath>

namespace suffuse::job {

double misfit_of(const std::vector<double>& curve, const LaboratoryCurve& laboratory) {
    const std::size_t n = laboratory.form.grid.size(), parts = laboratory.values.size() / n;
    double sum = 0;
    for (std::size_t part = 0; part < parts; ++part) {
        double squares = 0, largest = 0;
        for (std::size_t k = part * n; k < (part + 1) * n; ++k) {
            squares += std::pow(curve[static_cast<std::size_t>(laboratory.rows[k])] - laboratory.values[k], 2);
            largest = std::max(largest, std::abs(laboratory.values[k]));
        }
        sum += squares / (static_cast<double>(n) * largest * largest);
    }
    return std::sqrt(sum / static_cast<double>(parts));
}

} // namespace suffuse::job
