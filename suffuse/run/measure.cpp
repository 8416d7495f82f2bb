#include "suffuse/run/measure.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/casefile/wide_checks.hpp"
#include "suffuse/facts/state.hpp"
#include "suffuse/record/fact_json.hpp"
#include "suffuse/record/result_json.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::run {
std::string words_on_overlap(double ratio, const grains::Material& material, double notable) {
    if (!(ratio > notable)) {
        return "";
    }
    const double modulus = casefile::stiffer_modulus(material, ratio / casefile::good_squeezed);
    return fmt::format(
        "the largest overlap is {:.1f} % of the smaller radius; a contact.modulus of {} keeps it below {:.0f} %, and a "
        "lower pressure makes it smaller",
        100 * ratio, print_quantity(modulus, dimension::pressure), 100 * casefile::good_squeezed
    );
}

std::string words_on_hold(const std::vector<triaxial::PathRow>& rows, const triaxial::TriaxialSpec& spec) {
    const std::optional<double> error = triaxial::find_hold_error(rows, spec.path);
    if (!error || *error <= triaxial::good_hold_error || triaxial::summarize(rows, spec).lost_at) {
        return "";
    }
    return fmt::format(
        "the {} stress that the test holds is off by up to {:.2g} %; a quasi-static test keeps it within {:.0f} % in "
        "every row: take a smaller inertial_number, or more grains",
        spec.path == triaxial::Path::ConstantMean    ? "mean"
        : spec.path == triaxial::Path::ShearAtStress ? "normal"
                                                     : "lateral",
        100 * *error, 100 * triaxial::good_hold_error
    );
}

std::string words_on_stiffness(const triaxial::Stiffness& stiffness, const triaxial::StiffnessSpec& spec) {
    if (stiffness.nonlinearity > triaxial::elastic_within) {
        return fmt::format(
            "the moduli by a strain of {:.1e} and by half of it differ by {:.2g} % of the largest (at most {:.0f} %): "
            "the strain is outside the elastic range, or grains found another place during it; take a smaller "
            "increment, or a smaller unbalanced_force",
            spec.increment, 100 * stiffness.nonlinearity, 100 * triaxial::elastic_within
        );
    }
    return stiffness.anisotropy
               ? ""
               : "some small strain costs no work: the sample is not stable, and has no elastic moduli";
}

nlohmann::json measure_state(const dem::World& world, bool has_fractions) {
    const facts::State state{world};
    nlohmann::json numbers = record::facts_json(facts::state, state);
    if (state.balance.contacts > 0) {
        record::put_facts(numbers, facts::network, facts::Network{world});
    }
    const auto fines = std::count(world.grains.fine.begin(), world.grains.fine.end(), std::uint8_t{1});
    const bool has_both = fines > 0 && fines < static_cast<std::ptrdiff_t>(world.grains.size());
    if ((has_fractions || has_both) && !world.grains.id.empty()) {
        record::put_facts(numbers, facts::fines, facts::Fines{world, state.coordination});
    }
    return numbers;
}

} // namespace suffuse::run
