// figures: the figures of a run as files for a manuscript.

#include <fmt/format.h>

#include "apps/draw_figures.hpp"
#include "apps/exit_code.hpp"
#include "apps/page_folder.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <filesystem>

namespace suffuse::apps {

int figures_verb(const CommandLine& line, const Console& console) {
    const std::filesystem::path run = line.subject;
    const std::filesystem::path folder = line.output.empty() ? run / "figures" : std::filesystem::path(line.output);
    const std::string format = line.format.empty() ? "svg" : line.format;
    std::vector<std::string> written;
    for (const std::filesystem::path& file : draw_figures(run, line.figures, format, folder, page_folder())) {
        written.push_back(file.string());
        console.result(file.string());
    }
    console.talk(fmt::format("{} written to {}", plural(std::ssize(written), "figure"), folder.string()));
    console.document(json_text({{"figures", written}, {"format", format}}));
    return Done;
}

} // namespace suffuse::apps
