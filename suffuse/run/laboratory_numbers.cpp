#include "suffuse/run/laboratory_numbers.hpp"

#include "suffuse/facts/test.hpp"
#include "suffuse/record/fact_json.hpp"

namespace suffuse::run {
namespace {

nlohmann::json shear_rows(const triaxial::TriaxialSpec& spec, const std::vector<triaxial::PathRow>& curve) {
    const int normal = spec.shear_axes.normal;
    nlohmann::json rows = nlohmann::json::array();
    for (const triaxial::PathRow& row : curve) {
        rows.push_back(
            {{"shear_strain", row.shear_strain},
             {"shear_stress", triaxial::shear_stress(spec, row.stress)},
             {"normal_stress", row.stress(normal, normal)},
             {"void_ratio", row.void_ratio}}
        );
    }
    return rows;
}

nlohmann::json cyclic_rows(const triaxial::TriaxialSpec& spec, const std::vector<triaxial::PathRow>& curve) {
    const Mat3& start = curve.front().stress;
    const double lateral = 0.5 * (trace(start) - start(spec.axis, spec.axis));
    nlohmann::json rows = nlohmann::json::array();
    for (const triaxial::PathRow& row : curve) {
        rows.push_back(
            {{"cycle", 0.5 * row.leg},
             {"axial_strain", row.axial_strain},
             {"deviator_stress", row.deviator_stress},
             {"mean_stress", row.mean_stress},
             {"pore_pressure_ratio", row.excess_pore_pressure / lateral}}
        );
    }
    return rows;
}

} // namespace

nlohmann::json laboratory_numbers(const triaxial::TriaxialSpec& spec, const std::vector<triaxial::PathRow>& curve) {
    nlohmann::json numbers = nlohmann::json::object();
    if (!spec.stresses.empty()) {
        record::put_facts(numbers, facts::compression, triaxial::compression_numbers(spec, curve));
    } else if (triaxial::shears(spec.path)) {
        record::put_facts(numbers, facts::shear, triaxial::shear_numbers(spec, curve));
        numbers["rows"] = shear_rows(spec, curve);
    } else if (spec.cycles) {
        record::put_facts(numbers, facts::cyclic, triaxial::cyclic_numbers(spec, curve));
        numbers["rows"] = cyclic_rows(spec, curve);
    }
    return numbers;
}

} // namespace suffuse::run
