#include "apps/own_case_parts.hpp"

#include "suffuse/base/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace suffuse::apps {
namespace {

constexpr std::string_view material_form =
    R"([grain]
density = "2650 kg/m^3"               #~ quartz

[contact]                             # linear springs, Coulomb slip, rolling resistance
law               = "linear-rolling"
modulus           = {modulus:<18}#~ kn = 2 E r1 r2/(r1 + r2){stiffer}
shear_ratio       = 0.42              #~ ks/kn
friction          = "37 deg"          #~ between grains, in tests; preparation uses another
rolling_stiffness = 7.5               #~ kr = this x ks r1 r2
rolling_friction  = 0.22              #~ limits the rolling moment to this x min(r1, r2) x Fn
damping           = 0.2               #~ local, non-viscous

[fluid]
density   = "1000 kg/m^3"
viscosity = "1 mPa*s"
)";

constexpr double usual_modulus = 356e6; // [Pa]

/// Stiff enough for the finest grains at this pressure [Pa], to two digits [Pa].
double modulus_for(double largest_over_finest, double pressure, double largest_overlap) {
    grains::Material usual;
    usual.modulus = usual_modulus;
    const double squeezed = casefile::squeezed_overlap_at(pressure, usual, largest_over_finest);
    const double wanted = std::max(usual_modulus, usual_modulus * squeezed / largest_overlap);
    const double unit = std::pow(10.0, std::floor(std::log10(wanted)) - 1);
    return wanted > usual_modulus ? std::ceil(wanted / unit) * unit : usual_modulus;
}

} // namespace

std::string material_text(double largest_over_finest, double pressure, double largest_overlap) {
    const double modulus = modulus_for(largest_over_finest, pressure, largest_overlap);
    return fmt::format(
        material_form, fmt::arg("modulus", '"' + print_quantity(modulus, dimension::pressure) + '"'),
        fmt::arg(
            "stiffer",
            modulus > usual_modulus ? "; so that the finest grains between the coarsest overlap by about 5 %" : ""
        )
    );
}

const std::string_view gravity_text = R"(
[gravity]                             # fines have weight, less buoyancy; without this table they have none
down = "-z"
)";

std::string direction_text(const std::optional<FlowWay>& flow) {
    if (!flow) {
        return "\"z\"";
    }
    if (*flow == stability::upward) {
        return "\"z\"                       # upward, against the weight of the fines";
    }
    if (*flow == stability::downward) {
        return "\"-z\"                      # downward, with the weight of the fines";
    }
    if (*flow == stability::level_flow) {
        return "\"x\"                       # level, across the weight of the fines";
    }
    const double rise = stability::lift_of(*flow), ahead = std::sqrt(1 - rise * rise);
    return fmt::format(
        "{:<26}# {} at {:g} degrees", fmt::format("[{:.4f}, 0, {:.4f}]", ahead, rise), stability::kind_of(*flow),
        std::abs(flow->rise)
    );
}

std::string_view site_mark(const std::optional<double>& given) {
    return given ? "# as specified:" : "#~ yours:";
}

std::string sizes_line(const grains::Grading& modeled, const std::string& left_out) {
    if (left_out.empty()) {
        return {};
    }
    return fmt::format(
        "sizes = [\"{:.4g} mm\", \"{:.4g} mm\"] #~ without {}\n", 1e3 * modeled.diameter.front(),
        1e3 * modeled.diameter.back(), left_out
    );
}

} // namespace suffuse::apps
