#include "suffuse/job/report_options.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/figures/figure_options.hpp"
#include "suffuse/job/measured_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace suffuse::job {

void apply_report_options(const casefile::ReportSpec& spec, report::ReportData& data) {
    std::erase_if(data.figures, [&](const figures::Figure& figure) {
        return !figures::is_requested(spec.figures, figure);
    });
    for (figures::Figure& figure : data.figures) {
        if (spec.dilation_up) {
            figures::draw_dilation_up(figure);
        }
    }
    for (const auto& [word, file] : spec.overlay) {
        const std::string id = figures::figure_id(word);
        const auto figure = std::find_if(data.figures.begin(), data.figures.end(), [&](const figures::Figure& each) {
            return each.id == id;
        });
        if (figure == data.figures.end()) {
            data.warnings.push_back(fmt::format("report.overlay: this run has no {} to lay {} over", word, file));
            continue;
        }
        try {
            if (!figures::lay_over(*figure, read_points(file), std::filesystem::path(file).filename().string())) {
                data.warnings.push_back(fmt::format(
                    "report.overlay: {} has no two columns of {} that make up a panel; figures/{}.csv shows their "
                    "names",
                    file, word, id
                ));
            }
        } catch (const Error& error) {
            data.warnings.push_back(fmt::format("report.overlay: {}", error.what()));
        }
    }
}

} // namespace suffuse::job
