#include "suffuse/job/study_figures.hpp"

#include "suffuse/figures/figures_energy.hpp"
#include "suffuse/figures/figures_fines.hpp"
#include "suffuse/figures/figures_laboratory.hpp"
#include "suffuse/figures/figures_stiffness.hpp"
#include "suffuse/figures/figures_strength.hpp"
#include "suffuse/figures/figures_sweep.hpp"
#include "suffuse/figures/stress_probes.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/job/erosion_figures.hpp"
#include "suffuse/record/folder.hpp"
#include "suffuse/record/known_state.hpp"
#include "suffuse/study/trace_curves.hpp"
#include "suffuse/triaxial/path_loading.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::job {
namespace {

using Rows = std::vector<study::StressStrainRow>;

constexpr std::size_t most_tests = 24; ///< drawn in one figure of paths or energies

void add(std::optional<figures::Figure> figure, std::vector<figures::Figure>& figures) {
    if (figure) {
        figures.push_back(std::move(*figure));
    }
}

/// The test of one stage at one set of values, over its seeds.
struct Test {
    const casefile::Study* study = nullptr;
    const casefile::Stage* stage = nullptr;
    std::vector<std::string> written; ///< of the swept keys
    study::ResponseCurve curve;
    dem::EnergyParts energy; ///< at the end of the test, the mean over the seeds [J/m3]
};

Rows rows_of(const std::vector<triaxial::PathRow>& curve) {
    Rows rows;
    for (const triaxial::PathRow& row : curve) {
        rows.push_back(
            {row.axial_strain, row.volumetric_strain, row.deviator_stress, row.mean_stress, row.void_ratio,
             row.excess_pore_pressure}
        );
    }
    return rows;
}

double or_zero(const nlohmann::json& number) {
    return number.is_number() ? number.get<double>() : 0;
}

bool holds_deviator(const casefile::Stage& stage) {
    const auto* spec = std::get_if<triaxial::TriaxialSpec>(&stage.spec);
    return spec != nullptr && spec->path == triaxial::Path::ConstantDeviator;
}

/// Whether q over the axial strain is what a laboratory draws of the test.
bool is_compression(const casefile::Stage& stage) {
    return std::holds_alternative<triaxial::TriaxialSpec>(stage.spec) ||
           std::holds_alternative<triaxial::PlaneStrainSpec>(stage.spec);
}

/// Whether its load grows from the first row to the last, in a plane in which strains are known.
bool has_secant_modulus(const triaxial::TriaxialSpec& spec) {
    const bool turns = spec.cycles || !spec.stresses.empty() || spec.path == triaxial::Path::ConstantDeviator;
    return !turns && (is_axisymmetric(spec) || shears(spec.path));
}

/// All tests of the run, in the order of stages and of sweep values.
std::vector<Test> gather_tests(const study::RunResults& results) {
    std::vector<Test> tests;
    const std::vector<study::StudyCurves>& traced = results.curves;
    for (std::size_t s = 0; s < traced.size(); ++s) {
        const casefile::Study& study = results.what->studies[s];
        for (std::size_t k = 0; k < study.stages.size(); ++k) {
            for (const study::SweepPoint& point : traced[s].stages[k].points) {
                std::vector<Rows> of_seed;
                dem::EnergyParts energy; // summed over the seeds [J/m3]
                double borne = 0;        // pore pressure, summed over the seeds [Pa]
                for (const record::FinishedStage& stage : results.stages) {
                    if (is_compression(*stage.stage) && !stage.findings.curve.empty() &&
                        study::is_behind(stage, study, study.stages[k], point)) {
                        of_seed.push_back(rows_of(stage.findings.curve));
                        energy = energy + stage.findings.curve.back().energy;
                        borne += or_zero(stage.numbers.at("response").at("excess_pore_pressure"));
                    }
                }
                if (of_seed.empty()) {
                    continue;
                }
                const std::string values = study::values_name(traced[s].keys, point);
                const bool holds = holds_deviator(study.stages[k]);
                const auto seeds = static_cast<double>(of_seed.size());
                Test test{
                    &study, &study.stages[k], point.written, study::average_response(values, of_seed, holds),
                    (1 / seeds) * energy};
                if (holds) {
                    test.curve.borne_pore_pressure = borne / seeds;
                }
                for (std::size_t key = 0; key < study.sweep.size(); ++key) {
                    if (study.sweep[key].key == "fines_content") {
                        test.curve.fines_content = point.value[key];
                    }
                }
                tests.push_back(std::move(test));
            }
        }
    }
    return tests;
}

std::string kind_of_test(const casefile::Stage& stage) {
    const triaxial::TriaxialSpec* const spec = casefile::laboratory_test(stage.spec);
    const bool extends = spec != nullptr && spec->direction == triaxial::Direction::Extension;
    switch (spec == nullptr ? triaxial::Path::Drained : spec->path) {
    case triaxial::Path::Drained:
        return extends ? "Drained extension" : "Drained compression";
    case triaxial::Path::PlaneStrain:
        return extends ? "Extension in plane strain" : "Compression in plane strain";
    case triaxial::Path::ConstantMean:
        return "Compression at constant mean stress";
    case triaxial::Path::ConstantDeviator:
        return "Rise of the pore pressure at constant deviator stress";
    case triaxial::Path::Undrained:
        return extends ? "Undrained extension" : "Undrained compression";
    case triaxial::Path::Isotropic:
    case triaxial::Path::ShearAtVolume:
    case triaxial::Path::ShearAtStress:
        break; // drawn elsewhere
    case triaxial::Path::Proportional:
        return fmt::format("Compression with dεᵥ/dε₁ = {:g}", *spec->strain_ratio);
    }
    return {};
}

/// As names of figures are: lower-case letters, digits and hyphens.
std::string figure_name(std::string name) {
    for (char& letter : name) {
        const bool is_upper = letter >= 'A' && letter <= 'Z';
        const bool keeps = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || is_upper;
        letter = is_upper ? static_cast<char>(letter - 'A' + 'a') : keeps ? letter : '-';
    }
    return name;
}

/// The paths of the swept tests of each study, which may bear the same names as those of another, and those of all
/// others together.
void draw_paths(
    const std::vector<Test>& tests, std::vector<study::ResponseCurve> single, std::vector<figures::Figure>& figures
) {
    std::vector<const casefile::Study*> studies;
    for (const Test& test : tests) {
        if (!test.study->sweep.empty() && (studies.empty() || studies.back() != test.study)) {
            studies.push_back(test.study);
        }
    }
    const bool is_only = studies.size() + (single.empty() ? 0 : 1) == 1;
    for (const casefile::Study* study : studies) {
        std::vector<study::ResponseCurve> curves;
        for (const Test& test : tests) {
            if (test.study == study && curves.size() < most_tests) {
                curves.push_back(test.curve);
                curves.back().name += ", " + test.stage->name;
            }
        }
        std::optional<figures::Figure> figure = figures::test_paths(curves);
        if (figure && !is_only) {
            figure->id += fmt::format("-{}", figure_name(study->name));
            figure->title += ": " + study->name;
        }
        add(std::move(figure), figures);
    }
    single.resize(std::min(single.size(), most_tests));
    add(figures::test_paths(single), figures);
}

void draw_energy(const casefile::Case& what, const std::vector<Test>& tests, std::vector<figures::Figure>& figures) {
    std::vector<figures::TestEnergy> energies;
    for (const Test& test : tests) {
        if (energies.size() == most_tests) {
            break;
        }
        const std::string study = what.studies.size() > 1 ? test.study->name + ", " : "";
        const std::string values = test.study->sweep.empty() ? "" : test.curve.name + ", ";
        energies.push_back({study + values + test.stage->name, test.energy});
    }
    std::optional<figures::Figure> figure = figures::energy_of_tests(energies);
    if (figure && tests.size() > energies.size()) {
        figure->caption += fmt::format(" The first {} of {} tests.", energies.size(), tests.size());
    }
    add(std::move(figure), figures);
}

/// A figure for each swept test, and one for all others together.
void draw_tests(
    const casefile::Case& what, const std::vector<Test>& tests, const casefile::Stage* shown,
    std::vector<figures::Figure>& figures
) {
    std::vector<study::ResponseCurve> single, deviator_held;
    std::vector<const casefile::Stage*> drawn;
    for (const Test& test : tests) {
        if (test.study->sweep.empty()) {
            single.push_back(test.curve);
            single.back().name = (what.studies.size() > 1 ? test.study->name + ", " : "") + test.stage->name;
            if (test.curve.borne_pore_pressure) {
                deviator_held.push_back(single.back());
            }
            continue;
        }
        if (test.stage == shown || std::find(drawn.begin(), drawn.end(), test.stage) != drawn.end()) {
            continue;
        }
        drawn.push_back(test.stage);
        std::vector<study::ResponseCurve> of_stage;
        for (const Test& other : tests) {
            if (other.stage == test.stage) {
                of_stage.push_back(other.curve);
            }
        }
        add(figures::triaxial_response(
                of_stage, figure_name("own-triaxial-" + test.study->name + "-" + test.stage->name),
                fmt::format("{}: {}, stage {}", kind_of_test(*test.stage), test.study->name, test.stage->name)
            ),
            figures);
    }
    add(figures::triaxial_response(
            deviator_held, "own-pore-pressure", "Rise of the pore pressure at constant deviator stress"
        ),
        figures);
    std::vector<study::ResponseCurve> compressed = single;
    std::erase_if(compressed, [](const study::ResponseCurve& test) { return test.borne_pore_pressure.has_value(); });
    add(figures::triaxial_response(compressed), figures);
    draw_paths(tests, std::move(single), figures);
}

/// All cyclic tests, named by the study and the state that they start from.
std::vector<figures::LaboratoryTest> cyclic_tests_by_state(const study::RunResults& results) {
    std::vector<figures::LaboratoryTest> tests;
    for (const record::FinishedStage& stage : results.stages) {
        if (std::holds_alternative<triaxial::CyclicSpec>(stage.stage->spec) && stage.stage->parent >= 0) {
            const std::string& state = stage.variant->stages[static_cast<std::size_t>(stage.stage->parent)].name;
            const bool is_only = results.what->studies.size() == 1;
            tests.push_back({is_only ? state : stage.study->name + ", " + state, &stage});
        }
    }
    return tests;
}

/// The other tests of a laboratory, each kind in its own figure.
void draw_laboratory(const study::RunResults& results, std::vector<figures::Figure>& figures) {
    std::vector<figures::LaboratoryTest> compressed, sheared, cycled, probed, loaded;
    for (const record::FinishedStage& stage : results.stages) {
        const auto add_to = [&](std::vector<figures::LaboratoryTest>& kind) {
            if (kind.size() < most_tests) {
                const bool is_one_of_many = results.what->studies.size() > 1 || !stage.study->sweep.empty();
                kind.push_back({is_one_of_many ? stage.name() : stage.stage->name, &stage});
            }
        };
        if (std::holds_alternative<triaxial::StiffnessSpec>(stage.stage->spec)) {
            add_to(probed);
        }
        const triaxial::TriaxialSpec* const spec = casefile::laboratory_test(stage.stage->spec);
        if (spec == nullptr || stage.findings.curve.empty()) {
            continue;
        }
        auto* const kind = !spec->stresses.empty()        ? &compressed
                           : triaxial::shears(spec->path) ? &sheared
                           : spec->cycles                 ? &cycled
                                                          : nullptr;
        if (kind != nullptr) {
            add_to(*kind);
        }
        if (has_secant_modulus(*spec)) {
            add_to(loaded);
        }
    }
    add(figures::compression_curves(compressed), figures);
    add(figures::shear_curves(sheared), figures);
    add(figures::cyclic_curves(cycled), figures);
    add(figures::cyclic_resistance(cyclic_tests_by_state(results)), figures);
    add(figures::stiffness_points(probed), figures);
    add(figures::stiffness_over_strain(probed, loaded), figures);
}

/// What is mixed at each fines content, and the first sample's own grading.
std::vector<study::Mixture> describe_mixtures(
    const std::filesystem::path& folder, const study::FinesSweep& sweep,
    const std::vector<record::FinishedStage>& stages
) {
    std::vector<study::Mixture> mixtures;
    for (const double fines_content : sweep.curves.fines_content) {
        const auto stage = std::find_if(stages.begin(), stages.end(), [&](const record::FinishedStage& each) {
            return each.study == sweep.study && std::ranges::count(sweep.loose_stages, each.stage->name) > 0 &&
                   each.variant->soil && each.variant->soil->fines_content == fines_content;
        });
        if (stage == stages.end() || !stage->variant->soil->coarse) {
            continue;
        }
        const std::filesystem::path state = record::stage_folder(folder, *stage->variant, *stage->stage) / "state.h5";
        study::Mixture mixture{fines_content, grains::specified_grading(*stage->variant->soil), {}};
        if (std::filesystem::exists(state)) {
            mixture.sampled =
                sampled_grading(record::KnownState(state).load().world.grains.radius, stage->variant->soil);
        }
        mixtures.push_back(std::move(mixture));
    }
    return mixtures;
}

} // namespace

std::vector<figures::Figure> draw_study(const study::RunResults& results, const std::filesystem::path& folder) {
    std::vector<figures::Figure> figures;
    const casefile::Case& what = *results.what;
    if (const study::StudyOutcome* const outcome = study::main_outcome(results.outcomes)) {
        add(figures::sweep_result(*outcome), figures);
        add(figures::sweep_multiples(*outcome), figures);
    }
    const std::vector<Test> tests = gather_tests(results);
    const casefile::Stage* shown = nullptr;
    if (const auto& sweep = results.fines_sweep) {
        const auto axis =
            what.report.reversed_size_axis ? figures::GradingAxis::Reversed : figures::GradingAxis::LeftToRight;
        add(figures::mixture_gradings(describe_mixtures(folder, *sweep, results.stages), axis), figures);
        shown = study::loose_test(*sweep);
        std::vector<study::ResponseCurve> loose;
        for (const Test& test : tests) {
            if (test.stage == shown) {
                loose.push_back(test.curve);
            }
        }
        add(figures::loose_compression(loose), figures);
        const std::size_t before = figures.size();
        add(figures::void_ratios(sweep->curves), figures);
        add(figures::active_fines(sweep->curves), figures);
        add(figures::contact_classes(sweep->curves), figures);
        add(figures::strong_contacts(sweep->curves), figures);
        if (const std::string others = study::other_values(*sweep); !others.empty()) {
            std::for_each(figures.begin() + static_cast<std::ptrdiff_t>(before), figures.end(), [&](auto& figure) {
                figure.caption += fmt::format(" All at {}.", others);
            });
        }
    }
    add(figures::strength_before_and_after(results.strength, results.stages), figures);
    draw_tests(what, tests, shown, figures);
    draw_energy(what, tests, figures);
    draw_laboratory(results, figures);
    add(figures::stability_in_directions(results.probed_states), figures);
    return figures;
}

} // namespace suffuse::job
