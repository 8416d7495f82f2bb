#include "suffuse/answer/readings_table.hpp"

namespace suffuse::answer {

std::optional<figures::PageTable> tabulate_readings(const std::vector<study::Reading>& readings) {
    if (readings.size() < 2) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Erosion";
    table.title = "The paper's findings by reading";
    table.note =
        "A reading is a way from the sample to its last erosion: how grains are classified as detachable, and what "
        "happens between the passes. By noise: the grains that meet it move like their twins without water.";
    table.header = {"reading"};
    for (const study::Finding& finding : readings.front().findings) {
        table.header.push_back(finding.id);
    }
    table.numeric.assign(table.header.size(), false);
    for (const study::Reading& reading : readings) {
        std::vector<std::string> row{reading.name};
        for (const study::Finding& finding : reading.findings) {
            row.emplace_back(study::name_of(study::standing_of(finding)));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

} // namespace suffuse::answer
