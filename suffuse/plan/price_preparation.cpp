#include "suffuse/plan/price_preparation.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/packing/pace.hpp"
#include "suffuse/plan/preparation_price.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::plan {
namespace {

constexpr Range swift_start{2'500, 9'000}, swift_density{300, 1'500}; // from near touching; from a specified density
constexpr Range trials_for_a_density{2, 6};                           // compactions until a specified void ratio is met
constexpr Range searching{0.25, 0.55};                                // work of a step, a grain, while grains fly
constexpr Range geometry_seconds{1e-5, 6e-5};                         // a grain: pushing a cloud together

const Range& preparation_steps(std::string_view kind) {
    for (const PreparationPrice& price : preparation_prices) {
        if (price.kind == kind) {
            return price.steps;
        }
    }
    throw Bug(fmt::format("no price of the preparation {}", kind));
}

class Compaction {
public:
    Compaction(
        const casefile::Case& what, const casefile::Variant& variant, const packing::CompactSpec& spec,
        PricedSample& sample
    )
        : case_(what), variant_(variant), spec_(spec), sample_(sample) {}

    StagePrice price() {
        const bool seeks_density = (spec_.void_ratio || spec_.intergranular_void_ratio) && !takes_preparation();
        const double cloud = 1 - sample_.solid_fraction;
        const double start =
            spec_.start_porosity.value_or(leaves_out_gas() ? std::min(cloud, packing::open_porosity) : cloud);
        const Range pushing = start < cloud ? count(sample_) * geometry_seconds : Range{};
        const double gas_time_step = time_step(loose_time_step(sample_, variant_.material));
        const packing::EqualGrains state = seeks_density ? state_at(sample_, specified_solid_fraction())
                                                         : packing::equal_grains(friction(), adheres());
        take_state(sample_, state);
        sample_.pressure = spec_.pressure;
        const Range searches = count(sample_) * searching;
        if (spec_.protocol == packing::Protocol::Swift) {
            const Range trials = seeks_density ? Range{1, 3} : Range{1, 1};
            return {
                .steps = trials * ((seeks_density ? swift_density : swift_start) + waited(case_, {})),
                .seconds = trials * (count(sample_) * geometry_seconds),
                .memory_a_grain = grain_memory,
                .basis = "swift: pushed together, then pressed; contacts per grain some 0.6 above faithful's",
                .kind = seeks_density ? "swift, searched" : "swift",
                .more_work = searches};
        }
        const Range trials = seeks_density ? trials_for_a_density : Range{1, 1};
        const double end = 1 - sample_.solid_fraction;
        const double open = adheres() ? start : std::min(start, packing::open_porosity);
        const double stable = time_step(settled_time_step(sample_, variant_.material, lent()));
        const double rate = packing::largest_rate(spec_, variant_.material.density, sample_.median);
        const double gas = strain_between(start, open) / (rate * gas_time_step);
        const double loaded = strain_between(open, end) / (rate * stable);
        return {
            .steps = trials * (Range{gas, gas} + loaded * creep() * preparation_steps(kind()) + 2 * waited(case_, {})),
            .seconds = trials * pushing,
            .memory_a_grain = grain_memory,
            .basis = fmt::format(
                "{}: from a porosity of {:.2f} to some {:.2f} at {:.3g} 1/s and slower, then settling", kind(), start,
                end, rate
            ),
            .kind = kind() + (seeks_density ? ", searched" : ""),
            .only_pushes = only_pushes(),
            .more_work = searches};
    }

private:
    /// Whether another sample has searched for this one.
    [[nodiscard]] bool takes_preparation() const {
        return spec_.prepared_as && variant_.soil && variant_.soil->fines_content > *spec_.prepared_as;
    }

    [[nodiscard]] double friction() const { return spec_.prepare.friction.value_or(variant_.material.friction); }

    [[nodiscard]] bool adheres() const {
        return spec_.prepare.adhesion_normal.value_or(variant_.material.adhesion_normal) > 0 ||
               spec_.prepare.adhesion_shear.value_or(variant_.material.adhesion_shear) > 0;
    }

    [[nodiscard]] bool only_pushes() const { return !adheres() && !(friction() > 0); }

    [[nodiscard]] bool leaves_out_gas() const { return spec_.protocol != packing::Protocol::Slow && !adheres(); }

    /// On most of the way.
    [[nodiscard]] dem::Lent lent() const {
        return spec_.protocol == packing::Protocol::Wide
                   ? packing::lent_to_wide(sample_.median / smallest_diameter(sample_))
                   : dem::Lent{.mass = true};
    }

    /// Grains without friction creep until the slowest modes of the sample are at rest: for steps that grow as the root
    /// of its solid in median grains, to which smaller ones are slowed; 250 to 43,000 of them were seen [-].
    [[nodiscard]] double creep() const {
        constexpr double priced_for = 2'000; // median grains
        const bool creeps = only_pushes();
        const double solid = (sample_.coarse.mass + sample_.fines.mass) / case_.material.density;
        return creeps ? std::sqrt(solid / sphere_volume(0.5 * sample_.median) / priced_for) : 1;
    }

    /// A row of preparation_prices.
    [[nodiscard]] std::string kind() const {
        const std::string_view met = adheres() ? "adhesive" : friction() > 0 ? "frictional" : "frictionless";
        const bool first = spec_.prepare.skeleton_first;
        return fmt::format("{}, {}", first ? "skeleton first" : packing::name_of(spec_.protocol), met);
    }

    [[nodiscard]] double specified_solid_fraction() const {
        const double content = fines_content(sample_);
        const double e =
            spec_.void_ratio ? *spec_.void_ratio : *spec_.intergranular_void_ratio * (1 - content) - content;
        return 1 / (1 + std::max(e, 0.05)); // the run refuses less
    }

    [[nodiscard]] double time_step(double stable) const {
        if (spec_.time_step > 0) {
            return spec_.time_step;
        }
        if (spec_.protocol != packing::Protocol::Slow) {
            return stable;
        }
        return std::min(stable, packing::slow_time_step(0.5 * smallest_diameter(sample_), variant_.material));
    }

    const casefile::Case& case_;
    const casefile::Variant& variant_;
    const packing::CompactSpec& spec_;
    PricedSample& sample_;
};

} // namespace

StagePrice price_compaction(
    const casefile::Case& what, const casefile::Variant& variant, const packing::CompactSpec& spec, PricedSample& sample
) {
    return Compaction(what, variant, spec, sample).price();
}

} // namespace suffuse::plan
