// import, export: packings from and for other programs.

#include "suffuse/base/units.hpp"
#include "suffuse/dem/order.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/packing_file.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/verbs.hpp"
#include "apps/wording.hpp"
#include <algorithm>
#include <filesystem>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

constexpr double any_overlap = 1;      // only looked at, not judged
constexpr double usual_density = 2600; // [kg/m3]; a packing's geometry does not depend on it

nlohmann::json
describe(const io::ImportedPacking& read, const std::optional<cell::Cell>& cell, const std::string& file) {
    const auto [least, most] = std::minmax_element(read.grains.radius.begin(), read.grains.radius.end());
    nlohmann::json json = {
        {"file", file}, {"grains", read.grains.size()}, {"radius", {*least, *most}}, {"warnings", read.warnings}};
    if (cell) {
        const double solid = grains::solid_volume(read.grains), volume = cell::volume(*cell);
        json["porosity"] = 1 - solid / volume;
        json["void_ratio"] = volume / solid - 1;
        json["largest_overlap"] = io::check_overlaps(read.grains, *cell, any_overlap, file);
    }
    return json;
}

std::string sentence(const nlohmann::json& about) {
    std::string text = fmt::format(
        "{}: {} grains, d {} to {}", about["file"].get<std::string>(), count_text(about["grains"]),
        print_quantity(2 * about["radius"][0].get<double>(), dimension::length),
        print_quantity(2 * about["radius"][1].get<double>(), dimension::length)
    );
    if (about.contains("void_ratio")) {
        text += fmt::format(
            ", void ratio {:.4f}, largest overlap {:.2g} % of the smaller radius", about["void_ratio"].get<double>(),
            100 * about["largest_overlap"].get<double>()
        );
    }
    return text;
}

std::string format_of(const CommandLine& line) {
    const std::vector<std::string> formats{"csv", "yade", "xyz"};
    std::string format = line.format;
    if (format.empty()) {
        const std::string ending = fs::path(line.output).extension().string();
        format = ending == ".csv" ? "csv" : ending == ".txt" ? "yade" : ending == ".xyz" ? "xyz" : "";
        if (format.empty()) {
            throw UsageError(
                fmt::format("{} does not say its format; give --format csv, yade or xyz", shown(line.output))
            );
        }
    }
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
        throw UsageError(
            fmt::format("unknown format {}{}; there are csv, yade, xyz", shown(format), near_hint(format, formats))
        );
    }
    return format;
}

} // namespace

int import_verb(const CommandLine& line, const Console& console) {
    const io::ImportedPacking read = io::read_packing(line.subject, usual_density);
    std::optional<cell::Cell> cell = read.cell;
    if (!line.cell.empty()) {
        cell = cell::Cell{cell_of(line.cell), {}};
    }
    nlohmann::json about = describe(read, cell, line.subject);
    for (const std::string& warning : read.warnings) {
        console.talk("warning: " + warning);
    }
    if (!line.output.empty()) {
        io::export_csv(line.output, read.grains);
        about["written"] = line.output;
    }
    console.result(sentence(about));
    if (!cell) {
        console.talk("with --cell LX,LY,LZ also its void ratio and overlaps");
    }
    console.document(json_text(about));
    return Done;
}

int export_verb(const CommandLine& line, const Console& console) {
    const std::string format = format_of(line);
    const fs::path given = line.subject;
    const fs::path state = fs::is_directory(given) ? given / "state.h5" : given;
    dem::World world = io::load_world(state).world;
    dem::sort_by_id(world);
    if (format == "csv") {
        io::export_csv(line.output, world.grains);
    } else if (format == "yade") {
        io::export_yade(line.output, world.grains);
    } else {
        io::export_extended_xyz(line.output, world.grains, world.cell);
    }
    console.result(fmt::format("{}: {} grains", line.output, count_text(std::ssize(world.grains.radius))));
    console.document(json_text({{"written", line.output}, {"format", format}, {"grains", world.grains.size()}}));
    return Done;
}

} // namespace suffuse::apps
