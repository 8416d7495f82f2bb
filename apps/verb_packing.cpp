// import, export: packings from and for other programs.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/record/stage_sums.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

nlohmann::json describe(const io::TakenPacking& taken, const std::string& file) {
    const auto [least, most] = std::minmax_element(taken.grains.radius.begin(), taken.grains.radius.end());
    nlohmann::json json = {
        {"file", file}, {"grains", taken.grains.size()}, {"radius", {*least, *most}}, {"warnings", taken.warnings}};
    if (taken.h) {
        const Mat3& h = *taken.h; // rows of the matrix whose columns are the cell vectors
        json["cell"] = {{h(0, 0), h(0, 1), h(0, 2)}, {h(1, 0), h(1, 1), h(1, 2)}, {h(2, 0), h(2, 1), h(2, 2)}};
        const double solid = grains::solid_volume(taken.grains), volume = determinant(h);
        json["porosity"] = 1 - solid / volume;
        json["void_ratio"] = volume / solid - 1;
        json["largest_overlap"] = taken.overlap;
    }
    return json;
}

/// To four digits. (strtod, as stod throws at a length too small for a normal double, which a file may hold.)
std::string length_text(double length) {
    return print_quantity(std::strtod(fmt::format("{:.4g}", length).c_str(), nullptr), dimension::length);
}

std::string sentence(const nlohmann::json& about) {
    std::string text = fmt::format(
        "{}: {} grains, d {} to {}", about["file"].get<std::string>(), count_text(about["grains"]),
        length_text(2 * about["radius"][0].get<double>()), length_text(2 * about["radius"][1].get<double>())
    );
    if (about.contains("void_ratio")) {
        text += fmt::format(
            ", void ratio {}, largest overlap {} % of the smaller radius", digits_text(about["void_ratio"], 4),
            digits_text(100 * about["largest_overlap"].get<double>(), 2)
        );
    }
    return text;
}

/// Of what is written: as asked, or by the file's ending.
io::PackingFormat format_of(const CommandLine& line) {
    const std::vector<std::string> names = io::packing_format_names();
    const auto format =
        line.format.empty() ? io::packing_format_of_file(line.output) : io::packing_format_of_name(line.format);
    if (format) {
        return *format;
    }
    if (line.format.empty()) {
        throw UsageError(fmt::format(
            "{} does not say its format by its ending; give --format, one of {}", shown(line.output),
            fmt::join(names, ", ")
        ));
    }
    throw UsageError(fmt::format(
        "unknown format {}{}; there are {}", shown(line.format), near_hint(line.format, names), fmt::join(names, ", ")
    ));
}

/// "mm" or "1 mm" [m].
double unit_of(const std::string& text) {
    try {
        return parse_unit(text, dimension::length);
    } catch (const UnitError& error) {
        throw UsageError(fmt::format("--unit {}: {}; {}", shown(text), shown(error.what()), error.help));
    }
}

/// The grains that were read, as far as they are known: enough to write them in any format.
dem::World world_of(const io::TakenPacking& taken) {
    dem::World world;
    world.grains = taken.grains;
    world.cell.h = taken.h.value_or(world.cell.h);
    return world;
}

/// Whoever names a run instead of a stage is told the stages that it has.
void check_is_no_run(const fs::path& given) {
    if (!fs::is_directory(given / "studies")) {
        return;
    }
    std::vector<std::string> stages;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(given / "studies")) {
        if (entry.path().filename() == "state.h5") {
            stages.push_back(entry.path().parent_path().string());
        }
    }
    std::sort(stages.begin(), stages.end());
    throw UsageError(fmt::format(
        "{} is a run; give one of its stages: {}", shown(given.string()),
        stages.empty() ? "none is finished yet" : fmt::format("{}", fmt::join(stages, ", "))
    ));
}

} // namespace

int import_verb(const CommandLine& line, const Console& console) {
    io::PackingRequest request{.file = line.subject, .only_looks = true};
    if (!line.unit.empty()) {
        request.unit = unit_of(line.unit);
    }
    if (!line.cell.empty()) {
        request.cell = cell_of(line.cell);
    }
    const io::TakenPacking taken = io::take_packing(request);
    nlohmann::json about = describe(taken, line.subject);
    for (const std::string& warning : taken.warnings) {
        console.talk("warning: " + warning);
    }
    if (!line.output.empty()) {
        const io::PackingFormat format = format_of(line);
        if (!taken.h && format != io::PackingFormat::Csv && format != io::PackingFormat::Yade) {
            throw UsageError(fmt::format(
                "{}, and {} is written with one; give --cell LX,LY,LZ", shown(taken.no_cell), shown(line.output)
            ));
        }
        io::export_packing(line.output, world_of(taken), format);
        about["written"] = line.output;
    }
    console.result(sentence(about));
    if (!taken.h) {
        console.talk(shown(taken.no_cell) + "; with --cell LX,LY,LZ also its void ratio and overlaps");
    }
    console.document(json_text(about));
    return Done;
}

int export_verb(const CommandLine& line, const Console& console) {
    const fs::path given = line.subject;
    check_is_no_run(given);
    if (line.output.empty()) {
        throw UsageError(fmt::format(
            "export: where to? -o FILE names the file, and by its ending the format (--format for others): suffuse "
            "export {} -o grains.csv; there are {}",
            shell_word(line.subject), fmt::join(io::packing_format_names(), ", ")
        ));
    }
    const io::PackingFormat format = format_of(line);
    const fs::path state = fs::is_directory(given) ? given / "state.h5" : given;
    record::check_file(state);
    dem::World world = io::load_world(state).world;
    dem::sort_by_id(world);
    io::export_packing(line.output, world, format);
    console.result(fmt::format("{}: {} grains", line.output, count_text(std::ssize(world.grains.radius))));
    console.document(json_text({{"written", line.output}, {"grains", world.grains.size()}}));
    return Done;
}

} // namespace suffuse::apps
