#include "suffuse/run/eroded_table.hpp"

#include "suffuse/io/csv_writer.hpp"
#include "suffuse/record/result_json.hpp"

#include <string>

namespace suffuse::run {

void write_eroded(const std::filesystem::path& folder, const erosion::ErosionResult& result) {
    io::CsvWriter eroded(folder / "eroded.csv", "pass,id,d,mass,coordination,reason");
    for (const erosion::LedgerRow& row : result.ledger) {
        eroded.row(
            row.pass, row.grain, row.diameter, row.mass, row.coordination, nlohmann::json(row.reason).get<std::string>()
        );
    }
    eroded.finish();
}

} // namespace suffuse::run
