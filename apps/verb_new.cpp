// new: a commented case and its data, from an example or from a grading curve of the user's.

#include "suffuse/answer/surrogate_words.hpp"
#include "suffuse/base/amounts.hpp"
#include "suffuse/base/error.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/spelling.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/io/atomic_file.hpp"
#include "suffuse/io/folders.hpp"
#include "suffuse/plan/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/cut_verdicts.hpp"
#include "apps/exit_code.hpp"
#include "apps/grading_input.hpp"
#include "apps/json_text.hpp"
#include "apps/own_filter.hpp"
#include "apps/own_soil.hpp"
#include "apps/own_surrogate.hpp"
#include "apps/shared_options.hpp"
#include "apps/templates.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

struct NewVerb final : Verb {
    NewVerb()
        : Verb(
              "new", "write a commented case and its data as a starting point",
              "suffuse new my-dyke --psd dyke.csv --flow level -i 12m/30m"
          ) {}

    std::string given;           ///< folder, or a file of a grading curve
    std::string folder_of_curve; ///< behind that file
    std::string from;            ///< template
    std::string psd, sizes;      ///< grading curve, and the part of it that is modeled
    std::string fines;           ///< size below which grains are fine, with its unit
    std::string sample;          ///< of a file of several curves
    ReadingFlags reading;
    std::optional<std::int64_t> particles; ///< of the quick preset
    std::string pressure;                  ///< on the soil, with its unit
    std::optional<double> gradient;
    std::string filter; ///< grading curve of what is to hold that soil
    bool surrogate = false;
    std::string flow; ///< which way the water goes through fines that have weight

    void add_to(Options& options) override {
        options.argument(
            "DIR", given,
            "folder to write it to; the name of the template or of the curve unless given. A file of a grading curve "
            "instead is short for --psd FILE"
        );
        options.argument("FOLDER", folder_of_curve, "behind such a file: the folder to write it to");
        const Option example =
            options.value("--from", from, "an example to start from").type("NAME").suggest(template_names);
        options
            .value(
                "--psd", psd,
                std::string("of your own soil ") + grading_text +
                    "; read as by assess: --size, --passing, --retained, --share, --mass, --by, --sheet, --rows"
            )
            .type("FILE")
            .excludes(example);
        options.value("--sample", sample, "with --psd: only this sample of a table with several").type("NAME");
        reading.add_to(options, "");
        const Option part =
            options.value("--sizes", sizes, "with --psd: the part of the curve to model, as in 0.1mm,4mm")
                .type("FROM,TO");
        options
            .flag(
                "--surrogate", surrogate,
                "with --psd: two fractions stand for a soil too wide to simulate, with its size ratio and fines content"
            )
            .excludes(part)
            .excludes(example);
        options.value("--filter", filter, "with --psd: another grading, packed behind the soil: does it hold it?")
            .type("FILE")
            .excludes(part)
            .excludes(example);
        options
            .value(
                "--fines", fines, "with --psd: the size below which grains are fine; found on the curve unless given"
            )
            .type("D");
        options.value("--particles", particles, "with --psd: grains of the preset quick; by default as few as possible")
            .type("N")
            .whole_number(1, 10'000'000);
        options.value("--pressure", pressure, "with --psd: the effective stress on the soil; 100kPa is assumed")
            .type("P");
        options
            .value(
                "-i,--gradient", gradient,
                "with --psd: the hydraulic gradient of the seepage, as in 0.4 or 12m/30m; 0.05 is assumed"
            )
            .type("I")
            .ratio(0);
        options
            .value(
                "--flow", flow,
                "with --psd: up, down, level or a rise as 30deg; the fines then have weight, and the report gives the "
                "gradient that moves them"
            )
            .type("WAY");
    }

    [[nodiscard]] int act(const CommandLine&, const Console& console) const override;
};

struct NewFile {
    fs::path path;
    std::string text;
};

/// Writes all, or none where one exists. @return their paths.
std::vector<std::string> write_new(const std::vector<NewFile>& files) {
    for (const NewFile& file : files) {
        if (fs::exists(file.path)) {
            throw UsageError(fmt::format(
                "{} exists; give another folder, so that none of your files are overwritten", shown(file.path.string())
            ));
        }
    }
    std::vector<std::string> written;
    for (const NewFile& file : files) {
        io::make_folders(file.path.parent_path());
        io::write_file(file.path, file.text);
        written.push_back(file.path.string());
    }
    return written;
}

void print_next_steps(const fs::path& folder, const Console& console) {
    const std::string path = shell_word((folder / "case.toml").string());
    console.talk(fmt::format("next: suffuse check {}, suffuse plan {}, suffuse run {}", path, path, path));
}

int new_from_template(const NewVerb& verb, const Console& console) {
    const std::vector<std::string> names = template_names();
    if (std::find(names.begin(), names.end(), verb.from) == names.end()) {
        throw UsageError(fmt::format(
            "no template {}{}; there are {}", shown(verb.from), near_hint(verb.from, names), fmt::join(names, ", ")
        ));
    }
    const fs::path folder = verb.given.empty() ? verb.from : verb.given;
    std::vector<NewFile> files;
    for (const TemplateFile& file : template_files()) {
        if (file.name == verb.from) {
            files.push_back({folder / file.path, std::string(file.text)});
        }
    }
    const std::vector<std::string> written = write_new(files);
    console.result(fmt::format("{}", fmt::join(written, "\n")));
    console.document(json_text({{"written", written}}));
    print_next_steps(folder, console);
    return Done;
}

/// "0.1mm,4mm".
std::optional<SizeRange> sizes_of(const std::string& text) {
    if (text.empty()) {
        return std::nullopt;
    }
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos) {
        throw UsageError(
            fmt::format("--sizes {}: expected the finest and the coarsest size, as in 0.1mm,4mm", shown(text))
        );
    }
    const auto size = [](const std::string& word) { return quantity_of(word, dimension::length, "--sizes", false); };
    const SizeRange range{size(text.substr(0, comma)), size(text.substr(comma + 1))};
    if (!(range.first > 0 && range.second > range.first)) {
        throw UsageError(fmt::format("--sizes {}: the finest size comes first, and is above 0", shown(text)));
    }
    return range;
}

/// What the criteria say of the soil, and where a cut turned them.
void print_stability(const OwnSoil& soil, const CutVerdicts& verdicts, const Console& console) {
    if (verdicts.turned.empty()) {
        console.talk(fmt::format(
            "internal stability by the grading{}: {}", soil.left_out.empty() ? "" : ", as given and as modeled",
            verdicts.given
        ));
        return;
    }
    console.talk("internal stability of the grading as given: " + verdicts.given);
    console.talk("internal stability of the part that is modeled: " + verdicts.modeled);
    console.talk(fmt::format(
        "warning: cutting changes {} (whole soil -> modeled part): {}. The run answers only for the part",
        plural(std::ssize(verdicts.turned), "verdict"), turned_text(verdicts)
    ));
}

nlohmann::json stability_json(const CutVerdicts& verdicts) {
    nlohmann::json turned = nlohmann::json::array();
    for (const CutVerdicts::Turned& one : verdicts.turned) {
        turned.push_back({{"id", one.id}, {"given", one.given}, {"modeled", one.modeled}});
    }
    return {{"given", verdicts.given}, {"modeled", verdicts.modeled}, {"turned", turned}};
}

/// Priced as `suffuse plan` does: how stiff the contacts had to be counts as much as the number of grains.
plan::RunPlan price_of(const fs::path& path) {
    const casefile::Case what = casefile::load_case(path.string(), {}).value;
    ThreadOption{}.apply();
    return plan::plan_case(what, plan::samples_at_once(what));
}

OwnConditions conditions_of(const NewVerb& verb) {
    OwnConditions conditions{{}, verb.gradient, flow_way_of(verb.flow, "--flow")};
    if (!verb.pressure.empty()) {
        conditions.pressure = quantity_of(verb.pressure, dimension::pressure, "--pressure", false);
    }
    if (conditions.pressure && !(*conditions.pressure > 0)) {
        throw UsageError(fmt::format("--pressure {}: it is above 0", shown(verb.pressure)));
    }
    if (conditions.gradient && !(*conditions.gradient > 0)) {
        throw UsageError("--gradient 0: nothing seeps; it is above 0");
    }
    return conditions;
}

void print_assumed(const OwnConditions& conditions, const fs::path& path, const Console& console) {
    std::vector<std::string> assumed;
    if (!conditions.pressure) {
        assumed.push_back(fmt::format("a pressure of {}", print_quantity(assumed_pressure, dimension::pressure)));
    }
    if (!conditions.gradient) {
        assumed.push_back(fmt::format("a gradient of {}", assumed_gradient));
    }
    if (!assumed.empty()) {
        console.talk(fmt::format(
            "{} {} assumed: enter your own in {}", fmt::join(assumed, " and "), assumed.size() > 1 ? "are" : "is",
            shown(path.string())
        ));
    }
}

/// The curve of the user's soil, and the folder of its case.
struct OwnCurve {
    std::string path; ///< of the sheet
    std::string name; ///< as the file is called, so is the soil
    grains::Grading grading;
    std::string folder; ///< empty: that of the soil's name
};

/// A case that was written, and what it costs.
struct WrittenCase {
    fs::path folder;
    std::vector<std::string> files;
    plan::RunPlan plan;
};

WrittenCase
write_own_case(const OwnCurve& curve, const std::string& soil, const std::string& case_text, const Console& console) {
    WrittenCase written{curve.folder.empty() ? soil : curve.folder, {}, {}};
    written.files = write_new(
        {{written.folder / "case.toml", case_text},
         {written.folder / "data" / (soil + ".csv"), own_grading_text(curve.grading, curve.path)}}
    );
    console.result(fmt::format("{}", fmt::join(written.files, "\n")));
    written.plan = price_of(written.folder / "case.toml");
    return written;
}

int new_surrogate(
    const OwnCurve& curve, const std::optional<double>& limit, const NewVerb& verb, const OwnConditions& conditions,
    const Console& console
) {
    const double most = verb.particles ? static_cast<double>(*verb.particles) : most_quick_grains;
    const OwnSurrogate own = model_surrogate(curve.grading, curve.name, limit, most);
    const grains::Surrogate& surrogate = *own.soil.surrogate;
    const std::vector<std::string> left_out = answer::left_out_of(own.soil, own.ratios.back());
    const WrittenCase written = write_own_case(curve, own.name, own_case_text(own, conditions), console);
    const plan::RunPlan& plan = written.plan;
    console.document(json_text(
        {{"written", written.files},
         {"finer_than", surrogate.finer_than},
         {"fines_content", own.soil.fines_content},
         {"reason", own.reason},
         {"size_ratio", surrogate.ratio_of_soil},
         {"size_ratios", own.ratios},
         {"extrapolated", own.is_extrapolated()},
         {"left_out", left_out},
         {"pressure", conditions.pressure.value_or(assumed_pressure)},
         {"gradient", conditions.gradient ? nlohmann::json(*conditions.gradient) : nlohmann::json()},
         {"steps", {plan.steps.least, plan.steps.most}},
         {"seconds", {plan.seconds.least, plan.seconds.most}}}
    ));
    console.talk(fmt::format(
        "split at {:.4g} mm ({}): {:.3g} % of the mass are fines, size ratio D50/d50 = {:.3g}",
        1e3 * surrogate.finer_than, own.reason, 100 * own.soil.fines_content, surrogate.ratio_of_soil
    ));
    if (own.is_extrapolated()) {
        console.talk(fmt::format(
            "this ratio is out of reach: {:g} are simulated ({} grains at the last), and the soil's own gradients are "
            "an extrapolation",
            fmt::join(own.ratios, ", "), count_text(own.grains)
        ));
    }
    console.talk("a surrogate leaves out:");
    for (const std::string& sentence : left_out) {
        console.talk("  " + sentence);
    }
    console.talk(fmt::format("in the preset quick: {} on this machine", duration_range_text(plan.seconds)));
    print_next_steps(written.folder, console);
    return Done;
}

/// A base on its filter.
int new_stack(const OwnCurve& curve, const NewVerb& verb, const OwnConditions& conditions, const Console& console) {
    const gradings::GradingFile read = read_one_grading(verb.filter, "", verb.reading);
    print_remarks(read, console);
    const OwnStack stack = model_own_stack(curve.grading, curve.name, read.soils.front().grading, verb.filter);
    const fs::path folder = curve.folder.empty() ? stack.base + "-and-" + stack.filter : curve.folder;
    const std::vector<std::string> files = write_new(
        {{folder / "case.toml", own_case_text(stack, conditions)},
         {folder / "data" / (stack.base + ".csv"), own_grading_text(stack.base_curve, curve.path)},
         {folder / "data" / (stack.filter + ".csv"), own_grading_text(stack.filter_curve, verb.filter)}}
    );
    console.result(fmt::format("{}", fmt::join(files, "\n")));
    const plan::RunPlan plan = price_of(folder / "case.toml");
    console.document(json_text(
        {{"written", files},
         {"base_grains", stack.base_grains},
         {"filter_grains", stack.filter_grains},
         {"base_thickness", stack.base_thickness},
         {"filter_thickness", stack.filter_thickness},
         {"width", stack.width},
         {"gradient", conditions.gradient.value_or(assumed_base_gradient)},
         {"seconds", {plan.seconds.least, plan.seconds.most}}}
    ));
    console.talk(fmt::format(
        "{} grains of {} on {} of {}; in the preset quick: {} on this machine", count_text(stack.base_grains),
        stack.base, stack.filter_grains, stack.filter, duration_range_text(plan.seconds)
    ));
    print_next_steps(folder, console);
    return Done;
}

int new_from_soil(const NewVerb& verb, OwnCurve curve, const Console& console) {
    const OwnConditions conditions = conditions_of(verb); // what was typed is judged before what the file holds
    const gradings::GradingFile read = read_one_grading(curve.path, verb.sample, verb.reading);
    print_remarks(read, console);
    const std::string& sample = read.soils.front().name;
    curve.name = sample.empty() ? curve.path : sample + ".csv";
    curve.grading = read.soils.front().grading;
    const auto limit =
        verb.fines.empty() ? std::nullopt : std::optional(quantity_of(verb.fines, dimension::length, "--fines", false));
    if (!verb.filter.empty()) {
        return new_stack(curve, verb, conditions, console);
    }
    if (verb.surrogate) {
        return new_surrogate(curve, limit, verb, conditions, console);
    }
    const OwnSoil soil = model_own_soil(curve.grading, curve.name, {sizes_of(verb.sizes), limit, verb.particles});
    const CutVerdicts verdicts = judge_cut(soil.measured, soil.grading, soil.finer_than);
    const WrittenCase written = write_own_case(curve, soil.name, own_case_text(soil, conditions), console);
    const plan::RunPlan& plan = written.plan;
    console.document(json_text(
        {{"written", written.files},
         {"finer_than", soil.finer_than},
         {"fines_content", soil.fines_content},
         {"reason", soil.reason},
         {"left_out", soil.left_out},
         {"stability", stability_json(verdicts)},
         {"particles", soil.quick_grains},
         {"pressure", conditions.pressure.value_or(assumed_pressure)},
         {"gradient", conditions.gradient.value_or(assumed_gradient)},
         {"steps", {plan.steps.least, plan.steps.most}},
         {"seconds", {plan.seconds.least, plan.seconds.most}}}
    ));
    console.talk(fmt::format(
        "fines: finer than {:.4g} mm, {:.3g} % of the mass: {}", 1e3 * soil.finer_than, 100 * soil.fines_content,
        soil.reason
    ));
    if (!soil.left_out.empty()) {
        console.talk("left out: " + soil.left_out);
    }
    print_stability(soil, verdicts, console);
    console.talk(fmt::format(
        "{} grains in the preset quick: {} on this machine", count_text(soil.quick_grains),
        duration_range_text(plan.seconds)
    ));
    print_assumed(conditions, written.folder / "case.toml", console);
    print_next_steps(written.folder, console);
    return Done;
}

/// @throws UsageError for what belongs to a curve where there is none.
void expect_no_curve_options(const NewVerb& verb) {
    for (const auto& [option, is_given] :
         {std::pair{"--sample", !verb.sample.empty()},
          {"--size", !verb.reading.is_empty()},
          {"--sizes", !verb.sizes.empty()},
          {"--fines", !verb.fines.empty()},
          {"--surrogate", verb.surrogate},
          {"--filter", !verb.filter.empty()},
          {"--particles", verb.particles.has_value()},
          {"--pressure", !verb.pressure.empty()},
          {"--gradient", verb.gradient.has_value()},
          {"--flow", !verb.flow.empty()}}) {
        if (is_given) {
            throw UsageError(fmt::format("{} needs --psd FILE: it is about the soil of a grading curve", option));
        }
    }
}

int NewVerb::act(const CommandLine&, const Console& console) const {
    std::error_code ignored;
    const bool is_short = from.empty() && psd.empty() && fs::is_regular_file(given, ignored); // new soil.csv
    if (!is_short && !folder_of_curve.empty()) {
        throw UsageError(
            fmt::format("new: {} is no file of a grading curve; a second folder, {}, needs one", given, folder_of_curve)
        );
    }
    if (is_short || !psd.empty()) {
        return new_from_soil(*this, {is_short ? given : psd, {}, {}, is_short ? folder_of_curve : given}, console);
    }
    expect_no_curve_options(*this);
    if (from.empty()) {
        throw UsageError(fmt::format(
            "new: FILE or --psd FILE for your own soil, from its grading curve; or --from NAME for an example: {}",
            fmt::join(template_names(), ", ")
        ));
    }
    return new_from_template(*this, console);
}

} // namespace

MadeVerb make_new_verb() {
    return std::make_unique<NewVerb>();
}

} // namespace suffuse::apps
