// figures: the figures of a run as files for a manuscript.

#include "suffuse/base/amounts.hpp"
#include "suffuse/figures/figure_options.hpp"
#include "suffuse/job/draw_figures.hpp"
#include "suffuse/record/checksums.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/page_folder.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <filesystem>

namespace suffuse::apps {

namespace {

/// Of words such as 9 and own-paths.
std::vector<std::string> ids_of(std::vector<std::string> words) {
    std::ranges::transform(words, words.begin(), figures::figure_id);
    return words;
}

} // namespace

int figures_verb(const CommandLine& line, const Console& console) {
    const std::filesystem::path run = line.subject;
    const std::filesystem::path folder = line.output.empty() ? run / "figures" : std::filesystem::path(line.output);
    const std::string format = line.format.empty() ? "svg" : line.format;
    record::require_same_figures(run, ids_of(line.figures), {".vl.json", ".svg"});
    std::vector<std::string> written;
    for (const std::filesystem::path& file : job::draw_figures(run, line.figures, format, folder, page_folder())) {
        written.push_back(file.string());
        console.result(file.string());
    }
    console.talk(fmt::format("{} written to {}", plural(std::ssize(written), "figure"), folder.string()));
    console.document(json_text({{"figures", written}, {"format", format}}));
    return Done;
}

} // namespace suffuse::apps
