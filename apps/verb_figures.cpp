// figures: the figures of a run as files for a manuscript.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/figures/figure_options.hpp"
#include "suffuse/job/draw_figures.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/record/checksums.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/page_folder.hpp"
#include "apps/shared_options.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace suffuse::apps {
namespace {

struct FiguresVerb final : Verb {
    FiguresVerb()
        : Verb(
              "figures", "draw the figures of a run as files, for a manuscript",
              "suffuse figures runs/dyke-0001 --format pdf --figure 9 --figure own-rules -o manuscript"
          ) {}

    std::string run;
    std::string format = "svg";
    std::vector<std::string> figures; ///< numbers or names
    std::string output, width, font;

    void add_to(Options& options) override {
        options.argument("DIR", run, folder_text).required();
        options.value("--format", format, "svg, png or pdf; svg unless given")
            .type("NAME")
            .one_of({"svg", "png", "pdf"});
        options.values("--figure", figures, "only these, as in 9 or 9,10,own-rules; may be repeated").type("N");
        options.value("--width", width, "of each figure, as in 85mm; its own width unless given").type("LENGTH");
        options.value("--font", font, "font family of the manuscript; by default that of the report").type("NAME");
        options.value("-o,--output", output, "folder for the files; the run's figures/ unless given").type("DIR");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

/// "9,10" are two.
std::vector<std::string> at_commas(const std::vector<std::string>& names) {
    std::vector<std::string> words;
    for (const std::string& list : names) {
        std::istringstream rest(list);
        for (std::string word; std::getline(rest, word, ',');) {
            if (!word.empty()) {
                words.push_back(word);
            }
        }
    }
    return words;
}

/// Of words such as 9 and own-paths.
std::vector<std::string> ids_of(std::vector<std::string> words) {
    std::ranges::transform(words, words.begin(), figures::figure_id);
    return words;
}

int FiguresVerb::act(const CommandLine&, const Console& console) const {
    const std::filesystem::path own = std::filesystem::path(run) / "figures",
                                folder = output.empty() ? own : std::filesystem::path(output);
    if (std::filesystem::weakly_canonical(folder) != std::filesystem::weakly_canonical(own)) {
        job::require_outside_runs(folder);
    }
    const std::vector<std::string> wanted = at_commas(figures);
    look_at_run(run, output.empty() ? io::Purpose::Work : io::Purpose::Read, console);
    record::require_same_figures(run, ids_of(wanted), {".vl.json", ".svg"});
    job::DrawStyle style{.format = format, .width = std::nullopt, .font = font};
    if (!width.empty()) {
        constexpr double least = 0.03, most = 1; // [m]
        style.width = quantity_of(width, dimension::length, "--width", false);
        if (!(*style.width >= least && *style.width <= most)) {
            throw UsageError(fmt::format("--width {}: from 30 mm to 1 m, as in 85mm", shown(width)));
        }
    }
    std::vector<std::string> written;
    for (const std::filesystem::path& file : job::draw_figures(run, wanted, style, folder, page_folder())) {
        written.push_back(file.string());
        console.result(file.string());
    }
    console.talk(fmt::format("{} written to {}", plural(std::ssize(written), "figure"), folder.string()));
    console.document(json_text({{"figures", written}, {"format", format}}));
    return Done;
}

} // namespace

MadeVerb make_figures_verb() {
    return std::make_unique<FiguresVerb>();
}

} // namespace suffuse::apps
