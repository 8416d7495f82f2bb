#include "suffuse/job/draw_figures.hpp"

#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/figures/figure_options.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/io/text_file.hpp"
#include "suffuse/job/other_program.hpp"
#include "suffuse/job/scratch_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace suffuse::job {
namespace {

namespace fs = std::filesystem;

constexpr const char* specification_ending = ".vl.json";
constexpr const char* png_zoom = "3"; ///< about 290 dots an inch at a figure's own size

/// A figure of the run, either a specification to be drawn or a drawing.
struct Source {
    std::string id;
    fs::path file;
    bool is_drawing = false;
};

std::vector<Source> sources_in(const fs::path& run) {
    const fs::path folder = run / "figures";
    std::error_code error;
    std::vector<Source> sources;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        if (name.ends_with(specification_ending)) {
            sources.push_back({name.substr(0, name.size() - std::string(specification_ending).size()), entry.path()});
        } else if (name.ends_with(".svg") && !fs::exists(folder / (entry.path().stem().string() + specification_ending))) {
            sources.push_back({entry.path().stem().string(), entry.path(), true});
        }
    }
    if (error || sources.empty()) {
        throw IoError(fmt::format(
            "{}: holds no figures; give the folder of a run, or write them with suffuse report {}", folder.string(),
            shell_word(run.string())
        ));
    }
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) { return a.id < b.id; });
    return sources;
}

/// Which case draws a figure of the paper that a run has not; empty for other names.
std::string reason_for_missing(const std::string& id) {
    constexpr int tests = 2, last_of_mixtures = 6, last = 14; // section 3 of the paper is of mixtures, 4 of one soil
    const std::optional<int> number = figures::figure_of_paper(id);
    if (!number || *number < 1 || *number > last) {
        return "";
    }
    if (*number == tests) {
        return ": it needs tests of loose samples over the fines content, as in examples/silty-sand-2016/case.toml";
    }
    return *number <= last_of_mixtures
               ? ": it needs a study over the fines content, as in examples/silty-sand-2016/case.toml"
               : ": it needs an erosion with tests before and after, as in examples/fontainebleau-2016/case.toml";
}

std::vector<Source> chosen(const std::vector<Source>& all, const std::vector<std::string>& wanted) {
    if (wanted.empty()) {
        return all;
    }
    std::vector<std::string> ids;
    ids.reserve(all.size());
    for (const Source& source : all) {
        ids.push_back(source.id);
    }
    std::vector<Source> some;
    for (const std::string& word : wanted) {
        const auto found = std::find(ids.begin(), ids.end(), figures::figure_id(word));
        if (found == ids.end()) {
            const std::string elsewhere = reason_for_missing(figures::figure_id(word));
            throw UsageError(fmt::format(
                "--figure {}: this run has no such figure{}; it has {}", shown(word),
                elsewhere.empty() ? near_hint(figures::figure_id(word), ids) : elsewhere, fmt::join(ids, ", ")
            ));
        }
        some.push_back(all[static_cast<std::size_t>(found - ids.begin())]);
    }
    return some;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw IoError(fmt::format("{}: cannot be read", file.string()));
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// What draws specifications. @throws IoError saying what to install.
fs::path drawing_program(const fs::path& page) {
    if (!is_installed("node")) {
        throw IoError("node is missing, which draws the figures; install Node 18 or newer (Debian: nodejs)");
    }
    if (page.empty() || !fs::exists(page / "figures.mjs")) {
        throw IoError("the program that draws the figures was not built: let npm reach its registry and call ./run or "
                      "page/build.sh build/report-page once more");
    }
    return page / "figures.mjs";
}

std::vector<std::string> style_words(const DrawStyle& style) {
    constexpr double pixel = 0.0254 / 96; // of CSS [m]
    std::vector<std::string> words;
    if (style.width) {
        words.push_back(fmt::format("--width={:.2f}", *style.width / pixel));
    }
    if (!style.font.empty()) {
        words.push_back("--font=" + style.font);
    }
    return words;
}

/// Every figure as SVG in `folder`, by the built page's program. @return what it says of those that it could not draw
std::string
draw_svg(const std::vector<Source>& sources, const DrawStyle& style, const fs::path& folder, const fs::path& page) {
    std::vector<std::string> words = {"node", ""};
    std::ranges::move(style_words(style), std::back_inserter(words));
    words.push_back(folder.string());
    const std::size_t without_files = words.size();
    for (const Source& source : sources) {
        if (!source.is_drawing) {
            words.push_back(source.file.string());
        } else if (const fs::path copy = folder / source.file.filename(); copy != source.file) {
            io::write_file(copy, bytes_of(source.file));
        }
    }
    if (words.size() == without_files) {
        return {};
    }
    words[1] = drawing_program(page).string();
    const ProgramEnd end = run_program(words);
    return end.code == 0 ? "" : "node could not draw the figures: " + end.complaint;
}

void convert(const fs::path& svg, const fs::path& to, const std::string& format) {
    std::vector<std::string> words = {"rsvg-convert", "--format", format, "--output", to.string()};
    if (format == "png") {
        words.insert(words.end(), {"--zoom", png_zoom, "--background-color", "white"});
    }
    words.push_back(svg.string());
    if (const ProgramEnd end = run_program(words); end.code != 0) {
        throw IoError(fmt::format("rsvg-convert could not write {}: {}", to.string(), end.complaint));
    }
}

} // namespace

std::vector<fs::path> draw_figures(
    const fs::path& run, const std::vector<std::string>& wanted, const DrawStyle& style, const fs::path& folder,
    const fs::path& page
) {
    const std::string& format = style.format;
    const std::vector<Source> sources = chosen(sources_in(run), wanted);
    if (format != "svg" && !is_installed("rsvg-convert")) {
        throw IoError(fmt::format(
            "rsvg-convert is missing, which makes {} from SVG; install it (Debian: librsvg2-bin), or use --format svg",
            format
        ));
    }
    io::make_folders(folder);
    const ScratchFolder scratch(folder); // other programs write there: in the folder they would follow links
    const std::string complaint = draw_svg(sources, style, scratch.path(), page);
    std::vector<fs::path> written;
    for (const Source& source : sources) {
        const fs::path drawn = scratch.path() / (source.id + ".svg"),
                       made = scratch.path() / (source.id + "." + format);
        if (!complaint.empty() && !fs::exists(drawn)) {
            continue;
        }
        if (format != "svg") {
            convert(drawn, made, format);
        }
        written.push_back(folder / made.filename());
        io::write_file(written.back(), bytes_of(made));
    }
    if (!complaint.empty()) {
        throw IoError(complaint + fmt::format("\nothers that were drawn: {} in {}", written.size(), folder.string()));
    }
    return written;
}

void draw_in_page(std::vector<figures::Figure>& figures, const fs::path& run, const fs::path& page) {
    constexpr std::uintmax_t largest = 400'000; // of a drawing [bytes]: one of many thousand dots is the script's
    const char* const stills = std::getenv("SUFFUSE_STILLS");
    const bool is_wanted = stills == nullptr || std::string_view(stills) != "no";
    if (!is_wanted || page.empty() || !fs::exists(page / "figures.mjs") || !is_installed("node")) {
        return;
    }
    const ScratchFolder scratch(run);
    std::vector<std::string> words = {"node", (page / "figures.mjs").string(), "--in-page", scratch.path().string()};
    const std::size_t without_files = words.size();
    for (const figures::Figure& figure : figures) {
        if (figure.drawing.empty() && figure.flat.empty()) {
            words.push_back((run / "figures" / (figure.id + specification_ending)).string());
        }
    }
    if (words.size() == without_files) {
        return;
    }
    run_program(words); // what it could not draw is not there
    for (figures::Figure& figure : figures) {
        const fs::path file = scratch.path() / (figure.id + ".svg");
        std::error_code error;
        if (const auto bytes = fs::file_size(file, error); !error && bytes <= largest) {
            figure.still = io::read_text(file);
        }
    }
}

void draw_figure(const fs::path& run, const std::string& which, const fs::path& file, const fs::path& page) {
    const std::string ending = file.extension().string();
    if (ending != ".svg" && ending != ".png" && ending != ".pdf") {
        throw UsageError(fmt::format("{}: a figure is drawn as .svg, .png or .pdf", shown(file.string())));
    }
    const ScratchFolder scratch(file.has_parent_path() ? file.parent_path() : ".");
    const std::vector<fs::path> drawn = draw_figures(run, {which}, {.format = ending.substr(1)}, scratch.path(), page);
    io::write_file(file, bytes_of(drawn.front()));
}

} // namespace suffuse::job
