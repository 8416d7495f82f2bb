#include "suffuse/run/pass_record.hpp"

#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/result_json.hpp"

#include <string>

namespace suffuse::run {

using nlohmann::json;

json histogram_of(const std::map<int, std::int64_t>& coordination) {
    json histogram = json::object();
    for (const auto& [contacts, grains] : coordination) {
        histogram[std::to_string(contacts)] = grains;
    }
    return histogram;
}

json pass_record(const erosion::PassResult& pass) {
    return {
        {"pass", pass.pass},
        {"removed", pass.removed},
        {"eroded_mass_percent", pass.eroded_mass_percent},
        {"eroded_mass_percent_of_initial", pass.eroded_mass_percent_of_initial},
        {"coordination_histogram", histogram_of(pass.coordination_histogram)},
        {"stress_before", pass.stress_before},
        {"stress_after_removal", pass.stress_after_removal},
        {"stress_constant_volume", pass.stress_constant_volume},
        {"stress_after", pass.stress_after},
        {"porosity_before", pass.porosity_before},
        {"porosity_after_removal", pass.porosity_after_removal},
        {"porosity_after", pass.porosity_after},
        {"void_ratio_after", pass.void_ratio_after},
        {"fines_content_after", pass.fines_content_after},
        {"volumetric_strain", pass.volumetric_strain},
        {"steps", pass.steps},
        {"wall_seconds", pass.wall_seconds},
        {"verdict", pass.verdict}};
}

void write_eroded(const std::filesystem::path& folder, const erosion::ErosionResult& result) {
    io::CsvWriter eroded(folder / "eroded.csv", "pass,id,d,mass,coordination,reason");
    for (const erosion::LedgerRow& row : result.ledger) {
        eroded.row(row.pass, row.grain, row.diameter, row.mass, row.coordination, json(row.reason).get<std::string>());
    }
    eroded.finish();
}

} // namespace suffuse::run
