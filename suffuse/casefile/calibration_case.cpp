#include "suffuse/casefile/calibration_case.hpp"

#include "suffuse/base/read_text.hpp"
#include "suffuse/casefile/calibrate_fields.hpp"
#include "suffuse/casefile/calibration_places.hpp"
#include "suffuse/casefile/overrides.hpp"
#include "suffuse/casefile/read_toml.hpp"
#include "suffuse/casefile/refine.hpp"
#include "suffuse/casefile/sweep_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace suffuse::casefile {
namespace {

constexpr double inertial_number = 2e-3; // the fastest at which curves are those of a quasi-static test
constexpr std::int64_t rows_of_curve = 200;
constexpr double beyond = 1.02; // of the strain that is compared: no curve ends before it

/// What the study of a sample fixes of the case, unless the case says otherwise.
void set_usual(Node& root) {
    const auto set = [&](const char* table, const char* key, Node value) {
        if (root.find(table) == nullptr) {
            root.set(table, Node{});
        }
        Node& node = root.find(table)->value;
        if (node.find(key) == nullptr) {
            node.set(key, std::move(value));
        }
    };
    if (root.find("mode") == nullptr) {
        root.set("mode", make_node("fast"));
    }
    set("output", "formats", make_array({}));
    set("output", "snapshots", make_node("none"));
}

/// hertz-mindlin asks for both, though those of the samples are sought.
void set_sought(Node& root, const std::vector<CalibrateUnknown>& unknowns) {
    for (const std::string key : {"modulus", "poisson"}) {
        const auto unknown = std::ranges::find(unknowns, "contact." + key, &CalibrateUnknown::key);
        Node::Entry* contact = root.find("contact");
        if (unknown != unknowns.end() && contact != nullptr && contact->value.find(key) == nullptr) {
            contact->value.set(key, make_node(unknown->low));
        }
    }
}

/// Finds what is wrong with the rest of the case, with the samples at both ends of all ranges. @return warnings;
/// @throws CaseProblems
std::vector<Diagnostic> check_rest(const CalibrationCase& what) {
    std::vector<CalibrationSample> ends;
    for (int target = 0; target < static_cast<int>(what.spec.targets.size()); ++target) {
        for (const double share : {0.0, 1.0}) {
            ends.push_back({target, static_cast<int>(share), std::vector<double>(what.spec.unknowns.size(), share)});
        }
    }
    return load_samples(what, ends).warnings;
}

Scalar written_value(const CalibrateUnknown& unknown, double share) {
    const double value = value_at(unknown, share);
    return value_between(unknown.low, unknown.high, (value - unknown.least) / (unknown.most - unknown.least));
}

Node pressure_node(double pressure) {
    return make_node(Scalar(print_quantity(pressure, dimension::pressure)));
}

/// An oedometer goes to the largest stress of its record; before that is read, to some stress.
Node test_stage(const CalibrateTarget& target) {
    Node stage;
    stage.set("name", make_node("test"));
    if (target.test == CalibrateTest::Oedometer) {
        stage.set("do", make_node("oedometer"));
        stage.set("stresses", make_array({pressure_node(std::max(target.largest_stress, 2 * target.pressure))}));
    } else {
        stage.set("do", make_node("triaxial"));
        stage.set("path", make_node(target.test == CalibrateTest::Drained ? "drained" : "undrained"));
        // Strains of simulations are logarithmic.
        stage.set("strain", make_node(Scalar(-beyond * std::log1p(-target.strain))));
    }
    stage.set("inertial_number", make_node(Scalar(inertial_number)));
    stage.set("rows", make_node(Scalar(rows_of_curve)));
    return stage;
}

Node study_node(const CalibrationCase& what, const CalibrationSample& sample) {
    const CalibrateTarget& target = what.spec.targets.at(static_cast<std::size_t>(sample.target));
    const int own_void_ratio = void_ratio_of(what.spec, target);
    Node sweep, pack, compact;
    pack.set("name", make_node("cloud"));
    pack.set("do", make_node("pack"));
    const auto seed =
        static_cast<std::int64_t>(what.seed % 1'000'000) * 1'000'000 + sample.target * 10'000 + sample.number;
    sweep.set("seed", make_array({make_node(Scalar(seed))}));
    compact.set("name", make_node("sample"));
    compact.set("do", make_node("compact"));
    compact.set("pressure", pressure_node(target.pressure));
    compact.set("protocol", make_node("swift"));
    if (own_void_ratio < 0) {
        compact.set("void_ratio", make_node(Scalar(target.void_ratio.value())));
    }
    compact.set("void_ratio_tolerance", make_node(Scalar(target.void_ratio_tolerance)));
    for (std::size_t k = 0; k < what.spec.unknowns.size(); ++k) {
        const CalibrateUnknown& unknown = what.spec.unknowns[k];
        const Node value = make_node(written_value(unknown, sample.shares.at(k)));
        if (static_cast<int>(k) == own_void_ratio) {
            compact.set("void_ratio", value);
        } else if (!is_void_ratio(unknown.key)) {
            sweep.set(unknown.key, make_array({value}));
        }
    }
    Node study;
    study.set("soil", make_node(Scalar(what.spec.soil)));
    study.set("particles", make_node(Scalar(what.spec.particles)));
    study.set("sweep", std::move(sweep));
    study.set("stage", make_array({std::move(pack), std::move(compact), test_stage(target)}));
    return study;
}

} // namespace

bool calibrates(const std::string& path) {
    Problems problems; // load_calibration reports them
    const auto root = read_toml(std::make_shared<Source>(Source{path, read_whole_file(path)}), problems);
    return root && root->find("calibrate") != nullptr && root->find("study") == nullptr;
}

CalibrationCase load_calibration(const std::string& path, const LoadOptions& options) {
    Problems problems;
    CalibrationCase what;
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    what.folder = folder.string();
    auto root = read_toml(std::make_shared<Source>(Source{path, read_whole_file(path)}), problems);
    if (root) {
        for (const std::string& override_text : options.overrides) {
            apply_override(*root, override_text, problems);
        }
        ReadContext context{problems, what.folder, {}, {}, false, {}};
        if (const Node::Entry* entry = root->find("calibrate")) {
            what.spec = read_calibrate(context, *entry);
        } else {
            problems.error(
                "E201", root->place, "the case has no [calibrate]",
                "add a table [calibrate] with `soil`, `targets` and `unknowns`; docs/how-to/calibrate.md has an example"
            );
        }
        const Node::Entry *seed = root->find("seed"), *title = root->find("title");
        what.seed = seed != nullptr ? static_cast<std::uint64_t>(seed->value.integer) : 1;
        what.title = title != nullptr ? title->value.text : "";
        what.settings = print_file(*root);
        std::erase_if(root->entries, [](const Node::Entry& entry) {
            return entry.key == "calibrate" || entry.key == "study" || entry.key == "presets" || entry.key == "preset";
        });
        what.base = std::move(*root);
        set_usual(what.base);
        set_sought(what.base, what.spec.unknowns);
    }
    if (problems.has_errors()) {
        throw CaseProblems(problems.sorted());
    }
    what.warnings = check_rest(what);
    return what;
}

std::string study_of(const CalibrationCase& what, const CalibrationSample& sample) {
    return fmt::format("{}-{:04}", what.spec.targets.at(static_cast<std::size_t>(sample.target)).name, sample.number);
}

std::vector<double> values_of(const CalibrationCase& what, const CalibrationSample& sample) {
    std::vector<double> values;
    values.reserve(sample.shares.size());
    for (std::size_t k = 0; k < sample.shares.size(); ++k) {
        values.push_back(quantity_of(written_value(what.spec.unknowns[k], sample.shares[k]))->value);
    }
    return values;
}

LoadedCase load_samples(const CalibrationCase& what, const std::vector<CalibrationSample>& samples) {
    Node root = what.base, studies;
    for (const CalibrationSample& sample : samples) {
        studies.set(study_of(what, sample), study_node(what, sample));
    }
    root.set("study", std::move(studies));
    const std::string text = print_file(root);
    try {
        LoadedCase loaded = load_case_text(text, "samples of [calibrate]", what.folder);
        loaded.warnings = at_users_places(loaded.warnings, text, what);
        return loaded;
    } catch (const CaseProblems& problems) {
        throw CaseProblems(at_users_places(problems.problems, text, what));
    }
}

Case case_of_samples(const CalibrationCase& what, const std::vector<CalibrationSample>& samples) {
    return load_samples(what, samples).value;
}

} // namespace suffuse::casefile
