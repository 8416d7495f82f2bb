#include "apps/new_case.hpp"

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
#include "apps/json_text.hpp"
#include "apps/own_filter.hpp"
#include "apps/own_soil.hpp"
#include "apps/own_surrogate.hpp"
#include "apps/shared_options.hpp"
#include "apps/typed_value.hpp"
#include <utility>

namespace suffuse::apps {

namespace fs = std::filesystem;

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
    if (console.wants_json()) { // programs read `written`
        return;
    }
    const std::string path = shell_word((folder / "case.toml").string());
    console.talk(fmt::format("next: suffuse check {}, suffuse plan {}, suffuse run {}", path, path, path));
}

namespace {

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

OwnConditions conditions_of(const SoilRequest& request) {
    OwnConditions conditions{{}, request.gradient, flow_way_of(request.flow, "--flow")};
    if (!request.pressure.empty()) {
        conditions.pressure = quantity_of(request.pressure, dimension::pressure, "--pressure", false);
    }
    if (conditions.pressure && !(*conditions.pressure > 0)) {
        throw UsageError(fmt::format("--pressure {}: it is above 0", shown(request.pressure)));
    }
    if (conditions.gradient && !(*conditions.gradient > 0)) {
        throw UsageError("--gradient 0: nothing seeps; it is above 0");
    }
    return conditions;
}

void print_assumed(const OwnConditions& conditions, double gradient, const fs::path& path, const Console& console) {
    std::vector<std::string> assumed;
    if (!conditions.pressure) {
        assumed.push_back(fmt::format("a pressure of {}", print_quantity(assumed_pressure, dimension::pressure)));
    }
    if (!conditions.gradient) {
        assumed.push_back(fmt::format("a gradient of {:g}", gradient));
    }
    if (!assumed.empty()) {
        console.talk(fmt::format(
            "{} {} assumed: enter your own in {}", fmt::join(assumed, " and "), assumed.size() > 1 ? "are" : "is",
            shown(path.string())
        ));
    }
}

/// "table.csv --sample TP1": what names the curve to `suffuse assess`, or after --psd.
std::string curve_words(const SoilRequest& request) {
    return fmt::format(
        "{}{}{}", shell_word(request.curve_file),
        request.sample.empty() ? "" : " --sample " + shell_word(request.sample),
        request.reading.is_empty() ? "" : " " + gradings::command_words(request.reading)
    );
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

/// The path, or the outermost of its folders that does not exist yet.
fs::path outermost_new(fs::path path) {
    for (path = fs::absolute(path); !fs::exists(path.parent_path());) {
        path = path.parent_path();
    }
    return path;
}

/// Nothing stays of a case that cannot be priced.
WrittenCase write_case(const fs::path& folder, const std::vector<NewFile>& files, const Console& console) {
    std::vector<fs::path> made;
    for (const NewFile& file : files) {
        made.push_back(outermost_new(file.path));
    }
    WrittenCase written{folder, write_new(files), {}};
    try {
        written.plan = price_of(folder / "case.toml");
    } catch (...) {
        for (const fs::path& path : made) {
            fs::remove_all(path);
        }
        throw;
    }
    console.result(fmt::format("{}", fmt::join(written.files, "\n")));
    return written;
}

WrittenCase
write_own_case(const OwnCurve& curve, const std::string& soil, const std::string& case_text, const Console& console) {
    const fs::path folder = curve.folder.empty() ? soil : curve.folder;
    return write_case(
        folder,
        {{folder / "case.toml", case_text},
         {folder / "data" / (soil + ".csv"), own_grading_text(curve.grading, curve.path)}},
        console
    );
}

int new_surrogate(
    const OwnCurve& curve, const std::optional<double>& limit, const SoilRequest& request,
    const OwnConditions& conditions, const Console& console
) {
    const double most = request.particles ? static_cast<double>(*request.particles) : most_quick_grains;
    const OwnSurrogate own = model_surrogate(curve.grading, curve.name, limit, most, curve_words(request));
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

/// A base on its filter. What says how to read a file is about that of the base alone, as it is of assess: they rarely
/// have columns in common.
int new_stack(
    const OwnCurve& curve, const SoilRequest& request, const OwnConditions& conditions, const Console& console
) {
    const gradings::GradingFile read = read_one_grading(request.filter, request.filter_sample, {}, filter_sample_flag);
    print_remarks(read, console);
    const gradings::NamedGrading& filter = read.soils.front();
    const std::string name = filter.name.empty() ? request.filter : filter.name + ".csv";
    const std::string with_sample = request.filter_sample.empty()
                                        ? ""
                                        : fmt::format(" {} {}", filter_sample_flag, shell_word(request.filter_sample));
    const OwnStack stack = model_own_stack(
        curve.grading, curve.name, filter.grading, name,
        curve_words(request) + " --filter " + shell_word(request.filter) + with_sample
    );
    const fs::path folder = curve.folder.empty() ? stack.base + "-and-" + stack.filter : curve.folder;
    const WrittenCase written = write_case(
        folder,
        {{folder / "case.toml", own_case_text(stack, conditions)},
         {folder / "data" / (stack.base + ".csv"), own_grading_text(curve.grading, curve.path)},
         {folder / "data" / (stack.filter + ".csv"), own_grading_text(filter.grading, request.filter)}},
        console
    );
    const plan::RunPlan& plan = written.plan;
    console.document(json_text(
        {{"written", written.files},
         {"base_grains", stack.base_grains},
         {"filter_grains", stack.filter_grains},
         {"left_out", {{"base", stack.base_left_out}, {"filter", stack.filter_left_out}}},
         {"base_thickness", stack.base_thickness},
         {"filter_thickness", stack.filter_thickness},
         {"width", stack.width},
         {"pressure", conditions.pressure.value_or(assumed_pressure)},
         {"gradient", conditions.gradient.value_or(assumed_base_gradient)},
         {"seconds", {plan.seconds.least, plan.seconds.most}}}
    ));
    for (const auto& [soil, left_out] :
         {std::pair{stack.base, stack.base_left_out}, std::pair{stack.filter, stack.filter_left_out}}) {
        if (!left_out.empty()) {
            console.talk(fmt::format("left out of {}, for its sizes were not measured: {}", soil, left_out));
        }
    }
    console.talk(fmt::format(
        "{} grains of {} on {} of {}; in the preset quick: {} on this machine", count_text(stack.base_grains),
        stack.base, stack.filter_grains, stack.filter, duration_range_text(plan.seconds)
    ));
    print_assumed(conditions, assumed_base_gradient, folder / "case.toml", console);
    print_next_steps(folder, console);
    return Done;
}

} // namespace

int new_from_soil(const SoilRequest& request, const Console& console) {
    OwnCurve curve{request.curve_file, {}, {}, request.folder};
    const OwnConditions conditions = conditions_of(request); // what was typed is judged before what the file holds
    const gradings::GradingFile read = read_one_grading(curve.path, request.sample, request.reading);
    print_remarks(read, console);
    const std::string& sample = read.soils.front().name;
    curve.name = sample.empty() ? curve.path : sample + ".csv";
    curve.grading = read.soils.front().grading;
    const auto limit = request.fines.empty()
                           ? std::nullopt
                           : std::optional(quantity_of(request.fines, dimension::length, "--fines", false));
    if (!request.filter.empty()) {
        return new_stack(curve, request, conditions, console);
    }
    if (request.surrogate) {
        return new_surrogate(curve, limit, request, conditions, console);
    }
    const OwnSoil soil = model_own_soil(
        curve.grading, curve.name, {curve_words(request), sizes_of(request.sizes), limit, request.particles}
    );
    const CutVerdicts verdicts = judge_cut(soil.measured, soil.grading, soil.finer_than);
    const WrittenCase written = write_own_case(curve, soil.name, own_case_text(soil, conditions), console);
    const plan::RunPlan& plan = written.plan;
    console.document(json_text(
        {{"written", written.files},
         {"finer_than", soil.finer_than},
         {"fines_content", soil.fines_content},
         {"fines_of_whole", soil.fines_of_whole},
         {"reason", soil.reason},
         {"left_out", soil.left_out},
         {"stability", stability_json(verdicts)},
         {"particles", soil.quick_grains},
         {"pressure", conditions.pressure.value_or(assumed_pressure)},
         {"gradient", conditions.gradient.value_or(assumed_gradient)},
         {"steps", {plan.steps.least, plan.steps.most}},
         {"seconds", {plan.seconds.least, plan.seconds.most}}}
    ));
    console.talk(
        fmt::format("fines: finer than {:.4g} mm, {}: {}", 1e3 * soil.finer_than, fines_text(soil), soil.reason)
    );
    if (!soil.left_out.empty()) {
        console.talk("left out: " + soil.left_out);
    }
    print_stability(soil, verdicts, console);
    console.talk(fmt::format(
        "{} grains in the preset quick: {} on this machine", count_text(soil.quick_grains),
        duration_range_text(plan.seconds)
    ));
    print_assumed(conditions, assumed_gradient, written.folder / "case.toml", console);
    print_next_steps(written.folder, console);
    return Done;
}

} // namespace suffuse::apps
