#include "suffuse/run/mobility_record.hpp"

#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/or_null.hpp"
#include "suffuse/record/result_json.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <unordered_map>

namespace suffuse::run {

using nlohmann::json;

namespace {

json ramp_numbers(const erosion::MobilityResult& mobility) {
    json rows = json::array();
    for (const erosion::MobilityStep& step : mobility.ramp) {
        json row = step;
        row["floats"] = erosion::floats(mobility, step.gradient);
        row["still_growing"] = erosion::is_still_growing(step);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// A field of a table, empty where there is no number.
std::string field(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
}

} // namespace

const char* model_name(bool weighs) {
    return weighs ? "with weight" : "weightless";
}

json mobility_numbers(const erosion::MobilityResult& mobility) {
    json numbers = {
        {"mobility", ramp_numbers(mobility)},
        {"critical_gradient",
         {{"1 %", or_null(mobility.moves_1)},
          {"10 %", or_null(mobility.moves_10)},
          {"50 %", or_null(mobility.moves_50)}}},
        {"critical_gradient_at_most",
         {{"1 %", erosion::is_upper_bound(mobility, 0.01)},
          {"10 %", erosion::is_upper_bound(mobility, 0.1)},
          {"50 %", erosion::is_upper_bound(mobility, 0.5)}}},
        {"terzaghi_gradient", mobility.critical_gradient},
        {"heave_gradient", or_null(mobility.heave_gradient)},
        {"alpha_fines", or_null(mobility.alpha_fines)},
        {"skempton_brogan_gradient", or_null(mobility.skempton_brogan_gradient)},
        {"fines_heave_gradient", or_null(mobility.fines_heave_gradient)},
        {"single_grain_gradient", or_null(mobility.single_grain_gradient)},
        {"fines_drag_share", mobility.drag_share},
        {"load_bearing_mass_share", mobility.load_bearing_mass_share},
        {"sifting_mass_share", mobility.sifting_mass_share},
        {"sifts_under_its_weight", mobility.sifts},
        {"fallen_mass_share", mobility.fallen_mass_share},
        {"rested_for", mobility.rested_for},
        {"weight_scale", mobility.weight_scale},
        {"down", mobility.down},
        {"direction", mobility.direction},
        {"gravity", mobility.acceleration},
    };
    if (mobility.asked_gradient) {
        const std::optional<erosion::FactorOfSafety> safety = erosion::factor_of_safety(mobility);
        numbers["asked_gradient"] = *mobility.asked_gradient;
        numbers["mobile_mass_share_at_asked"] = or_null(erosion::mobile_share_at(mobility, *mobility.asked_gradient));
        numbers["factor_of_safety"] = safety ? or_null(safety->factor) : json();
        if (safety && !safety->factor) {
            numbers["factor_of_safety_at_least"] = safety->at_least;
        }
    }
    return numbers;
}

void write_mobility(const std::filesystem::path& folder, std::span<const erosion::MobilityResult* const> ramps) {
    const std::string columns = "gradient,mobile_mass_share,mobile_number_share,leaving_mass_share,still_growing";
    io::CsvWriter table(folder / "mobility.csv", ramps.size() > 1 ? columns + ",pass" : columns);
    int pass = 0;
    for (const erosion::MobilityResult* ramp : ramps) {
        ++pass;
        for (const erosion::MobilityStep& step : ramp->ramp) {
            const auto write = [&](const auto&... more) {
                table.row(
                    step.gradient, step.mobile_mass_share, step.mobile_number_share, field(step.leaving_mass_share),
                    erosion::is_still_growing(step) ? 1 : 0, more...
                );
            };
            if (ramps.size() > 1) {
                write(pass);
            } else {
                write();
            }
        }
    }
    table.finish();
}

std::vector<double> mobile_gradients(const dem::World& world, const erosion::MobilityResult& mobility) {
    std::unordered_map<std::uint32_t, double> known;
    for (std::size_t k = 0; k < mobility.id.size(); ++k) {
        known[mobility.id[k]] = mobility.mobile_gradient[k];
    }
    std::vector<double> gradients(world.grains.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t g = 0; g < gradients.size(); ++g) {
        if (const auto found = known.find(world.grains.id[g]); found != known.end()) {
            gradients[g] = found->second;
        }
    }
    return gradients;
}

void note_mobility(StageWork& work, const std::string& when, const erosion::MobilityResult& mobility) {
    constexpr double restless = 0.05; // of the number of fines
    if (mobility.sifts) {
        work.warnings.push_back(fmt::format(
            "{}: {}{:.2g} % of the fines' mass sift through the skeleton under their own weight, without any flow: "
            "this soil cannot be placed as it is modeled here, and what a gradient moves is what weight has left",
            work.place(), when, 100 * mobility.sifting_mass_share
        ));
    }
    for (const erosion::MobilityStep& step : mobility.ramp) {
        if (step.still_moving > restless) {
            work.warnings.push_back(fmt::format(
                "{}: {}at i = {:.3g} {:.2g} % of the fines still advanced after {:.4g} units of time, and the gradient "
                "rose: shares from there on are lower bounds; a larger `hold_at_most` holds it longer",
                work.place(), when, step.gradient, 100 * step.still_moving, step.held_for
            ));
            return;
        }
    }
}

} // namespace suffuse::run
