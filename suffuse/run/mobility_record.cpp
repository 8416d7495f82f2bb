#include "suffuse/run/mobility_record.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/io/csv_writer.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <unordered_map>

namespace suffuse::run {

namespace {

/// A field of a table, empty where there is no number.
std::string field(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
}

} // namespace

const char* model_name(bool weighs) {
    return weighs ? "with weight" : "weightless";
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
            "{}: {}{} % of the fines' mass sift through the skeleton under their own weight, without any flow: "
            "the modeled soil segregates under its own weight, and a gradient can only move the fines that remain",
            work.place(), when, short_number(100 * mobility.sifting_mass_share, 2)
        ));
    }
    for (const erosion::MobilityStep& step : mobility.ramp) {
        if (step.still_moving > restless) {
            work.warnings.push_back(fmt::format(
                "{}: {}at i = {:.3g} {} % of the fines still advanced after {:.4g} units of time, and the gradient "
                "rose: shares from there on are lower bounds; a larger `hold_at_most` holds it longer",
                work.place(), when, step.gradient, short_number(100 * step.still_moving, 2), step.held_for
            ));
            return;
        }
    }
}

} // namespace suffuse::run
