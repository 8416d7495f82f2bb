#include "suffuse/answer/removal_table.hpp"

#include "suffuse/base/words.hpp"
#include "suffuse/study/study_curves.hpp"

#include <fmt/format.h>

#include <map>

namespace suffuse::answer {

namespace {

std::string percent_over_seeds(const std::vector<double>& of_seed) {
    return study::with_scatter(study::scatter_of(of_seed), 100);
}

std::vector<std::string> row_of(const std::vector<const study::Removal*>& removals) {
    std::vector<double> ratio, mass, strain, loss, left;
    bool failed = false;
    for (const study::Removal* removal : removals) {
        ratio.push_back(removal->stress_ratio);
        mass.push_back(removal->removed_share);
        strain.push_back(removal->strain);
        loss.push_back(removal->stress_loss);
        failed = failed || removal->failed;
        if (removal->peak_before && removal->peak_after) {
            left.push_back(*removal->peak_after / *removal->peak_before);
        }
    }
    return {
        short_number(100 * removals.front()->fines_content),
        short_number(study::scatter_of(ratio).mean, 2),
        fmt::format("{}", removals.size()),
        percent_over_seeds(mass),
        (failed ? "above " : "") + percent_over_seeds(strain),
        percent_over_seeds(loss),
        percent_over_seeds(left)};
}

} // namespace

std::optional<figures::PageTable> removal_table(const std::vector<study::Removal>& removals) {
    if (removals.empty()) {
        return std::nullopt;
    }
    figures::PageTable table;
    table.section = "Tests";
    table.title = "Removal of all fines at once";
    table.note = "Strain: the largest of an axis, while the stresses are held; “above” if the skeleton no longer "
                 "carried them. Loss of mean stress: at constant volume, before. Highest q: of compression without the "
                 "fines, of that with them.";
    table.header = {"fines content [%]",  "q/p before [-]",          "samples",      "removed mass [%]",
                    "largest strain [%]", "loss of mean stress [%]", "highest q [%]"};
    table.numeric.assign(table.header.size(), true);
    for (const bool is_isotropic : {true, false}) {
        std::map<double, std::vector<const study::Removal*>> of_content;
        for (const study::Removal& removal : removals) {
            if ((removal.stress_ratio < study::isotropic_below) == is_isotropic) {
                of_content[removal.fines_content].push_back(&removal);
            }
        }
        for (const auto& [content, there] : of_content) {
            table.rows.push_back(row_of(there));
        }
    }
    return table;
}

} // namespace suffuse::answer
