#include "suffuse/job/laboratory_readings.hpp"

#include "suffuse/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace suffuse::job {

using casefile::CalibrateTarget;
using laboratory::Quantity;

Readings::Readings(const laboratory::TestRecord& record, const CalibrateTarget& target)
    : record_(record), target_(target) {
    const auto named = std::ranges::find(record.tests, target.sample, &laboratory::NamedTest::name);
    const bool is_only = target.sample.empty() && record.tests.size() == 1;
    if (named == record.tests.end() && !is_only) {
        complain(
            target.sample.empty()
                ? fmt::format(
                      "holds {} tests; name one, as in sample = \"{}\"", record.tests.size(), record.tests.front().name
                  )
                : fmt::format(
                      "has no test \"{}\"; its tests are \"{}\" to \"{}\"", target.sample, record.tests.front().name,
                      record.tests.back().name
                  )
        );
    }
    range_ = is_only ? record.tests.front() : *named;
}

Values Readings::of(Quantity quantity) const {
    const laboratory::TestColumn* column = record_.find(quantity);
    if (column == nullptr) {
        complain(fmt::format("has no column of {}", laboratory::row_of(quantity).name));
    }
    const auto begin = column->values.begin();
    return {begin + static_cast<std::ptrdiff_t>(range_.begin), begin + static_cast<std::ptrdiff_t>(range_.end)};
}

void Readings::complain(const std::string& what) const {
    throw CaseError(fmt::format("target \"{}\": {} {}", target_.name, target_.file, what));
}

Values since_start(Values values) {
    const double start = values.empty() ? 0 : values.front();
    for (double& value : values) {
        value -= start;
    }
    return values;
}

Values stress_of(const Readings& readings, Quantity quantity, bool as_effective) {
    Values stress = readings.of(quantity);
    if (as_effective && !readings.find(quantity)->is_effective.value_or(true)) {
        std::ranges::transform(stress, readings.of(Quantity::PorePressure), stress.begin(), std::minus());
    }
    return stress;
}

Values deviator_of(const Readings& readings) {
    if (readings.find(Quantity::DeviatorStress) != nullptr) {
        return readings.of(Quantity::DeviatorStress);
    }
    const auto is_effective = [&](Quantity quantity) {
        const laboratory::TestColumn* column = readings.find(quantity);
        return column != nullptr ? column->is_effective : std::nullopt;
    };
    const auto axial = is_effective(Quantity::AxialStress), radial = is_effective(Quantity::RadialStress);
    const bool are_mixed = axial && radial && *axial != *radial;
    Values deviator = stress_of(readings, Quantity::AxialStress, are_mixed);
    std::ranges::transform(
        deviator, stress_of(readings, Quantity::RadialStress, are_mixed), deviator.begin(), std::minus()
    );
    return deviator;
}

Values mean_of(const Readings& readings, double pressure) {
    if (readings.find(Quantity::MeanStress) != nullptr) {
        return stress_of(readings, Quantity::MeanStress, true);
    }
    Values effective = deviator_of(readings);
    constexpr std::array shares{std::pair{Quantity::RadialStress, 1. / 3}, std::pair{Quantity::AxialStress, -2. / 3}};
    for (const auto& [quantity, share] : shares) {
        if (readings.find(quantity) != nullptr) {
            const Values stress = stress_of(readings, quantity, true);
            std::ranges::transform(effective, stress, effective.begin(), [share = share](double q, double one) {
                return one + share * q;
            });
            return effective;
        }
    }
    const Values water = since_start(readings.of(Quantity::PorePressure));
    std::ranges::transform(effective, water, effective.begin(), [&](double q, double u) {
        return pressure + q / 3 - u;
    });
    return effective;
}

std::optional<Values> lateral_stress_of(const Readings& readings) {
    const bool has_water = readings.find(Quantity::PorePressure) != nullptr;
    const auto is_known = [&](Quantity quantity) {
        const laboratory::TestColumn* column = readings.find(quantity);
        return column != nullptr && (has_water || column->is_effective.value_or(true));
    };
    if (is_known(Quantity::RadialStress)) {
        return stress_of(readings, Quantity::RadialStress, true);
    }
    if (!is_known(Quantity::MeanStress)) {
        return std::nullopt;
    }
    Values lateral = stress_of(readings, Quantity::MeanStress, true);
    std::ranges::transform(lateral, deviator_of(readings), lateral.begin(), [](double p, double q) {
        return p - q / 3;
    });
    return lateral;
}

} // namespace suffuse::job
