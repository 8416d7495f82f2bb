// import: a packing from another program, looked at and written in another format; the record of a laboratory test.

#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/io/checkpoint.hpp"
#include "suffuse/io/packing_checks.hpp"
#include "suffuse/io/packing_export.hpp"
#include "suffuse/io/text_file.hpp"
#include "suffuse/job/run_folder.hpp"

#include <fmt/format.h>

#include "apps/exit_code.hpp"
#include "apps/json_text.hpp"
#include "apps/shared_options.hpp"
#include "apps/test_import.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

namespace suffuse::apps {
namespace {

struct ImportVerb final : Verb {
    ImportVerb()
        : Verb(
              "import", "check a packing of another program or a laboratory test, or convert a packing",
              "suffuse import pack.txt --cell 0.004,0.004,0.004 -o packing.xyz"
          ) {}

    std::string file, kind, contraction;
    CellOption cell;
    std::string box;    ///< corners of what is cut out of a bed
    std::string radius; ///< of all grains, where the file has none
    std::string unit;   ///< what a length of 1 in the file stands for
    PackingOutput output;

    void add_to(Options& options) override {
        options.argument("FILE", file, std::string(packing_text) + "; or a table of a laboratory test").required();
        options
            .value("--kind", kind, "of the file: packing (unless given), or a test: triaxial, oedometer, permeameter")
            .type("KIND")
            .suggest(kinds_of_files);
        options
            .value(
                "--contraction", contraction,
                "positive or negative: sign of volumetric strains that contract, where a test does not show it"
            )
            .type("SIGN")
            .suggest(std::vector<std::string>{"positive", "negative"});
        cell.add_to(options);
        options
            .value(
                "--box", box,
                "lower and upper corner of a box to cut out of a bed, in meters: the grains with their centers in it, "
                "as a periodic cell"
            )
            .type("X1,Y1,Z1,X2,Y2,Z2");
        options.value("--unit", unit, "of lengths without a unit in the file, as in mm; m unless given").type("UNIT");
        options.value("--radius", radius, "of all grains, where the file has none: in m or in --unit, or as in 0.5mm")
            .type("R");
        output.add_to(options);
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

nlohmann::json describe(const io::TakenPacking& taken, const std::string& file) {
    const auto [least, most] = std::minmax_element(taken.grains.radius.begin(), taken.grains.radius.end());
    nlohmann::json json = {
        {"file", file}, {"grains", taken.grains.size()}, {"radius", {*least, *most}}, {"warnings", taken.warnings}};
    if (taken.left_out) {
        json["outside_box"] = taken.left_out->outside;
        json["across_faces"] = taken.left_out->across;
    }
    if (taken.h) {
        const Mat3& h = *taken.h; // rows of the matrix whose columns are the cell vectors
        json["cell"] = {{h(0, 0), h(0, 1), h(0, 2)}, {h(1, 0), h(1, 1), h(1, 2)}, {h(2, 0), h(2, 1), h(2, 2)}};
        const double solid = grains::solid_volume(taken.grains), volume = determinant(h);
        json["porosity"] = 1 - solid / volume;
        json["void_ratio"] = volume / solid - 1;
        json["contacts"] = taken.contacts;
        json["coordination_number"] =
            2 * static_cast<double>(taken.contacts) / static_cast<double>(taken.grains.size());
        json["largest_overlap"] = taken.overlap;
        json["mean_overlap"] = taken.mean_overlap;
    }
    return json;
}

/// To four digits. (strtod, as stod throws at a length too small for a normal double, which a file may hold.)
std::string length_text(double length) {
    return print_quantity(std::strtod(fmt::format("{:.4g}", length).c_str(), nullptr), dimension::length);
}

std::string sentence(const nlohmann::json& about) {
    std::string text = fmt::format(
        "{}: {}, d {} to {}", about["file"].get<std::string>(), plural(about["grains"], "grain"),
        length_text(2 * about["radius"][0].get<double>()), length_text(2 * about["radius"][1].get<double>())
    );
    if (about.contains("void_ratio")) {
        text += fmt::format(
            ", void ratio {}, coordination number {}, largest overlap {} % of the smaller radius, mean {} %",
            digits_text(about["void_ratio"], 4), digits_text(about["coordination_number"], 3),
            digits_text(100 * about["largest_overlap"].get<double>(), 2),
            digits_text(100 * about["mean_overlap"].get<double>(), 2)
        );
    }
    if (about.contains("outside_box")) {
        text += fmt::format(
            "; left out: {} outside of the box, {} that overlap across its faces", count_text(about["outside_box"]),
            count_text(about["across_faces"])
        );
    }
    return text;
}

/// "mm" or "1 mm" [m].
double unit_of(const std::string& text) {
    try {
        return parse_unit(text, dimension::length);
    } catch (const UnitError& error) {
        throw UsageError(fmt::format("--unit {}: {}; {}", shown(text), shown(error.what()), error.help));
    }
}

/// "0.5", in the file's unit, or "0.5mm" [m].
std::optional<double> radius_of(const std::string& text, double file_unit) {
    if (text.empty()) {
        return std::nullopt;
    }
    const auto plain = io::number_of<double>(text);
    const double radius = plain ? *plain * file_unit : quantity_of(text, dimension::length, "--radius", false);
    if (!(radius > 0) || !std::isfinite(radius)) {
        throw UsageError(fmt::format("--radius {}: it is above 0", shown(text)));
    }
    return radius;
}

/// The grains that were read, as far as they are known: enough to write them in any format.
dem::World world_of(const io::TakenPacking& taken) {
    dem::World world;
    world.grains = taken.grains;
    world.cell.h = taken.h.value_or(world.cell.h);
    return world;
}

int ImportVerb::act(const CommandLine&, const Console& console) const {
    if (!kind.empty() && kind != packing_kind) {
        if (!(cell.edges.empty() && box.empty() && radius.empty() && unit.empty() && output.file.empty())) {
            throw UsageError("--kind " + shown(kind) + " only looks at a test; leave out the options of packings");
        }
        return import_test(file, kind, contraction, console);
    }
    if (!contraction.empty()) {
        throw UsageError("--contraction is of tests; give --kind triaxial, or leave it out");
    }
    io::PackingRequest request{.file = file, .only_looks = true};
    if (!unit.empty()) {
        request.unit = unit_of(unit);
    }
    request.radius = radius_of(radius, request.unit);
    request.cell = cell.matrix();
    if (!box.empty()) {
        request.box = box_of(box);
    }
    if (request.box && request.cell) {
        throw UsageError("--box and --cell: the box is the cell; give one of them");
    }
    const io::TakenPacking taken = io::take_packing(request);
    nlohmann::json about = describe(taken, file);
    for (const std::string& warning : taken.warnings) {
        console.talk("warning: " + warning);
    }
    if (!output.file.empty()) {
        const io::PackingFormat format = output.chosen_format();
        job::require_outside_runs(output.file);
        if (!taken.h && io::needs_cell(format)) {
            throw UsageError(fmt::format(
                "{}, and {} is written with one; give --cell LX,LY,LZ", shown(taken.no_cell), shown(output.file)
            ));
        }
        io::export_packing(output.file, world_of(taken), format);
        about["written"] = output.file;
    }
    console.result(sentence(about));
    if (!taken.h) {
        console.talk(shown(taken.no_cell) + "; with --cell LX,LY,LZ also its void ratio and overlaps");
    }
    console.document(json_text(about));
    return Done;
}

} // namespace

MadeVerb make_import_verb() {
    return std::make_unique<ImportVerb>();
}

} // namespace suffuse::apps
