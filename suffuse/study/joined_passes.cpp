#include "suffuse/study/joined_passes.hpp"

#include <cmath>
#include <utility>

namespace suffuse::study {
namespace {

using erosion::ErosionResult;

/// Volumetric strain of the same grains from one porosity to another, compression positive [-].
double strain_between(double porosity_before, double porosity_after) {
    return std::log((1 - porosity_after) / (1 - porosity_before));
}

void add(const ErosionResult& later, ErosionResult& all) {
    const int passes_before = all.passes.empty() ? 0 : all.passes.back().pass;
    const double mass_left = later.initial_mass / all.initial_mass;
    const std::int64_t first_step = all.path.empty() ? 0 : all.path.back().step;
    double first_strain = all.path.empty() ? 0 : all.path.back().volumetric_strain;
    if (!all.passes.empty() && !later.passes.empty()) { // what another stage did between the two
        first_strain += strain_between(all.passes.back().porosity_after, later.passes.front().porosity_before);
    }
    for (erosion::PassResult pass : later.passes) {
        pass.pass += passes_before;
        pass.eroded_mass_percent_of_initial *= mass_left;
        all.passes.push_back(std::move(pass));
    }
    for (erosion::LedgerRow row : later.ledger) {
        row.pass += passes_before;
        all.ledger.push_back(row);
    }
    for (erosion::PathRow row : later.path) {
        row.pass += passes_before;
        row.step += first_step;
        row.volumetric_strain += first_strain;
        row.eroded_mass = 1 - (1 - row.eroded_mass) * mass_left;
        all.path.push_back(row);
    }
}

} // namespace

ErosionResult join_passes(const std::vector<const ErosionResult*>& stages) {
    if (stages.empty()) {
        return {};
    }
    ErosionResult all = *stages.front();
    for (std::size_t k = 1; k < stages.size(); ++k) {
        add(*stages[k], all);
    }
    return all;
}

} // namespace suffuse::study
