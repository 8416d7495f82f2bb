// assess: assess the internal stability of a soil from its grading, without simulation.

#include "suffuse/base/error.hpp"
#include "suffuse/base/parallel.hpp"
#include "suffuse/base/shell_word.hpp"
#include "suffuse/base/units.hpp"
#include "suffuse/casefile/load_case.hpp"
#include "suffuse/grains/sampling.hpp"
#include "suffuse/job/assessed_soil.hpp"
#include "suffuse/job/run_folder.hpp"
#include "suffuse/job/stability_matrix.hpp"
#include "suffuse/stability/open_curve.hpp"

#include <fmt/format.h>

#include "apps/alpha_of_run.hpp"
#include "apps/assess_advice.hpp"
#include "apps/exit_code.hpp"
#include "apps/failed_files.hpp"
#include "apps/grading_input.hpp"
#include "apps/json_text.hpp"
#include "apps/playground.hpp"
#include "apps/shared_options.hpp"
#include "apps/show_readings.hpp"
#include "apps/stability_pages.hpp"
#include "apps/typed_value.hpp"
#include "apps/verb.hpp"
#include "apps/verbs.hpp"
#include <algorithm>
#include <cctype>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace suffuse::apps {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;

bool is_folder(const std::string& file) {
    return fs::is_directory(file);
}

/// A case, or a run of one.
bool of_case(const std::string& file) {
    return file.ends_with(".toml") || is_folder(file);
}

struct AssessVerb final : Verb {
    AssessVerb()
        : Verb(
              "assess", "assess the internal stability of a soil from its grading, without simulation",
              "suffuse assess dyke.csv --fines 0.2mm -i 0.3 -o dyke-stability\nsuffuse assess borehole-*.csv"
          ) {}

    std::vector<std::string> files; ///< gradings, or cases
    std::string sample;             ///< of a file that holds several
    ReadingFlags reading;
    bool shows_reading = false;
    std::string filter, filter_sample; ///< another soil, which is to hold these
    bool wants_page = false;
    std::string fines; ///< size below which grains are fine, with its unit
    std::optional<double> seepage_gradient, relative_density, porosity;
    std::string density; ///< of the grains, with its unit
    std::optional<double> stress_share;
    std::string flow;               ///< which way the water goes
    std::string alpha_from;         ///< folder of a run whose samples say it
    bool has_coarse_fabric = false; ///< uniformity of the coarse part alone
    std::string output;

    void add_to(Options& options) override {
        options
            .arguments(
                "FILE", files,
                std::string(grading_text) + "; or a case, for all its soils; or the folder of a run, with the alpha "
                                            "of its samples"
            )
            .required();
        options.value("--sample", sample, "only this sample of a table with several").type("NAME");
        options.flag("--show-reading", shows_reading, "print which columns are read as what, and the points; no more");
        reading.add_to(options, "COLUMN[:UNIT] and other words on how FILE is read: docs/gradings.md");
        const Option other =
            options.value("--filter", filter, "another grading: is it a filter for these soils?").type("FILE");
        options.value(filter_sample_flag, filter_sample, "with --filter: only this sample of a table with several")
            .type("NAME")
            .needs(other);
        options.flag("--page", wants_page, "write one HTML file in which curves and sliders can be moved");
        options.value("--fines", fines, "size below which grains count as fine; found on the curve unless given")
            .type("D");
        options.value("-i,--gradient", seepage_gradient, "hydraulic gradient of the seepage, as in 0.4 or 12m/30m")
            .type("I")
            .ratio(0);
        options
            .value(
                "--flow", flow, "with -i: up, down, level or a rise as 30deg; a head over a path through a dam is level"
            )
            .type("WAY");
        options.value("--relative-density", relative_density, "0 loosest, 1 densest; both unless given")
            .type("ID")
            .ratio(0, 1);
        options.value("--porosity", porosity, "with -i; 0.40 unless given").type("N").ratio(0.05, 0.95);
        options.value("--density", density, "of the grains, with -i; 2650kg/m^3 unless given").type("RHO");
        options.value("--alpha", stress_share, "with -i: mean effective stress in the fines over that of the soil")
            .type("A")
            .ratio(0, 1);
        options
            .value("--alpha-from", alpha_from, "folder of a run: alpha, porosity and density are those of its samples")
            .type("RUN");
        options.flag("--coarse-fabric", has_coarse_fabric, "D60/D10 of the coarse part decides up to which F");
        options
            .value(
                "-o,--output", output,
                "folder for a page, its figures and numbers; FILE.pdf, .svg or .png: the curves alone; with --page the "
                "page"
            )
            .type("DIR");
    }

    [[nodiscard]] int act(const CommandLine& line, const Console& console) const override;

    /// "table.csv --sample TP1 --by number": what names the first soil to another verb.
    [[nodiscard]] std::string base_words(const std::string& file) const {
        return fmt::format(
            "{}{}{}", shell_word(case_of_run(file)), sample.empty() ? "" : " --sample " + shell_word(sample),
            reading.is_empty() ? "" : " " + gradings::command_words(reading)
        );
    }

    /// What to type then. @param file of the first soil
    [[nodiscard]] std::string next_step(
        const std::string& file, const std::vector<job::AssessedSoil>& soils, const stability::AssessSpec& spec
    ) const {
        if (soils.size() > 1) {
            return output.empty() ? "-o DIR draws the curves over each other, with a page for each soil"
                                  : "suffuse assess FILE shows one of them in full";
        }
        return of_case(file) ? advise_run(base_words(file))
                             : advise_new(soils.front().measured, base_words(file), fines, spec.finer_than);
    }
};

/// With the alpha of the run that was named, or of the one that is assessed.
stability::AssessSpec with_alpha(
    const AssessVerb& verb, const std::string& file, const stability::AssessSpec& spec, const std::string& soil,
    const Console& console
) {
    const AlphaSource alpha{
        !verb.alpha_from.empty() ? verb.alpha_from
        : is_folder(file)        ? file
                                 : "",
        verb.seepage_gradient, verb.porosity,
        verb.density.empty() ? std::nullopt
                             : std::optional(quantity_of(verb.density, dimension::density, "--density", false)),
        verb.stress_share};
    stability::AssessSpec with = with_alpha_of_run(alpha, spec, soil, console);
    if (with.seepage) {
        with.seepage->flow = flow_way_of(verb.flow, "--flow");
    }
    return with;
}

stability::AssessSpec spec_of(const AssessVerb& verb) {
    stability::AssessSpec spec;
    if (!verb.fines.empty()) {
        spec.finer_than = quantity_of(verb.fines, dimension::length, "--fines", false);
    }
    spec.relative_density = verb.relative_density;
    spec.fabric = verb.has_coarse_fabric ? stability::PrimaryFabric::Coarse : stability::PrimaryFabric::Soil;
    const bool has_seepage_options = verb.porosity || verb.stress_share || !verb.density.empty() || !verb.flow.empty();
    const bool has_run = !verb.alpha_from.empty() || std::ranges::any_of(verb.files, is_folder);
    if (has_seepage_options && !verb.seepage_gradient && !has_run) {
        throw UsageError("--porosity, --density, --alpha and --flow go with a gradient: add -i I");
    }
    if (verb.seepage_gradient) {
        stability::Seepage seepage;
        seepage.gradient = *verb.seepage_gradient;
        seepage.porosity = verb.porosity.value_or(seepage.porosity);
        if (!verb.density.empty()) {
            seepage.grain_density = quantity_of(verb.density, dimension::density, "--density", false);
        }
        seepage.stress_share = verb.stress_share;
        spec.seepage = seepage;
    }
    return spec;
}

/// A soil that is to be assessed.
struct MeasuredSoil {
    std::string file, name;
    fs::path folder;
    grains::Grading measured;
    stability::AssessSpec spec;
};

void add_case_soils(
    const AssessVerb& verb, const std::string& file, const stability::AssessSpec& spec, const Console& console,
    std::vector<MeasuredSoil>& soils
) {
    const casefile::Case what = load_given_case(case_of_run(file), {}, console);
    const bool of_other_case = !verb.alpha_from.empty(); // whose soils have names of their own
    for (const auto& [name, soil] : what.soils) {
        stability::AssessSpec own = with_alpha(verb, file, spec, of_other_case ? "" : name, console);
        own.finer_than = spec.finer_than ? spec.finer_than : soil.finer_than;
        soils.push_back(
            {file, fmt::format("{}, soil {}", file, name), what.soils.size() > 1 ? name : "",
             soil.measured ? *soil.measured : grains::specified_grading(soil), own}
        );
    }
    if (what.soils.empty()) {
        throw CaseError(file + ": the case has no soil; its packing is imported, and has no grading to assess");
    }
}

/// How a file was understood, told and kept.
void note_remarks(const gradings::GradingFile& read, const Console& console, json& remarks) {
    print_remarks(read, console);
    for (const Diagnostic& remark : read.remarks) {
        remarks.push_back(remark_text(remark));
    }
}

/// All soils of all files that can be read, and how these were understood.
std::vector<MeasuredSoil> read_all(
    const AssessVerb& verb, const stability::AssessSpec& spec, const Console& console, json& remarks,
    FailedFiles& failed
) {
    std::vector<MeasuredSoil> soils;
    for (const std::string& file : verb.files) {
        if (of_case(file)) {
            failed.attempt(file, console, [&] { add_case_soils(verb, file, spec, console, soils); });
            continue;
        }
        gradings::GradingFile read;
        failed.attempt(file, console, [&] { read = read_gradings_of(file, verb.sample, verb.reading); });
        note_remarks(read, console, remarks);
        for (gradings::NamedGrading& soil : read.soils) {
            const std::string name = soil.name.empty() ? file : fmt::format("{}, {}", file, soil.name);
            soils.push_back({file, name, soil.name, std::move(soil.grading), with_alpha(verb, file, spec, "", console)}
            );
        }
    }
    return soils;
}

/// What could be judged; of `measured` the same is kept.
std::vector<job::AssessedSoil>
assess_all(std::vector<MeasuredSoil>& measured, const Console& console, FailedFiles& failed) {
    ThreadOption{}.apply();
    std::vector<job::AssessedSoil> soils(measured.size());
    std::vector<std::exception_ptr> errors(measured.size());
    run_side_by_side(measured.size(), thread_count(), [&](std::size_t k) {
        const MeasuredSoil& soil = measured[k];
        try {
            soils[k] = {soil.name, soil.folder, stability::assess_measured(soil.measured, soil.spec), soil.measured};
        } catch (const CaseError&) {
            errors[k] = std::current_exception();
        }
    });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < measured.size(); ++k) {
        if (errors[k]) {
            failed.attempt(measured[k].file, console, [&] { std::rethrow_exception(errors[k]); });
        } else {
            std::swap(measured[kept], measured[k]);
            std::swap(soils[kept++], soils[k]);
        }
    }
    measured.resize(kept);
    soils.resize(kept);
    return soils;
}

/// Judges another soil as a filter of all of them.
void add_filter(const AssessVerb& verb, const Console& console, json& remarks, std::vector<job::AssessedSoil>& soils) {
    const gradings::GradingFile read = read_one_grading(verb.filter, verb.filter_sample, {}, filter_sample_flag);
    note_remarks(read, console, remarks);
    const gradings::NamedGrading& filter = read.soils.front();
    const std::string name = filter.name.empty() ? verb.filter : fmt::format("{}, {}", verb.filter, filter.name);
    for (job::AssessedSoil& soil : soils) {
        const grains::Grading& measured = filter.grading;
        soil.filter = {
            name, stability::check_filter(soil.measured, measured), job::consult_filter_atlas(soil.measured, measured),
            measured};
    }
}

/// A folder for each soil, where there are several: its sample's name or its file's, in letters that no shell minds.
std::string folder_of(const job::AssessedSoil& soil, std::size_t number) {
    std::string name = soil.folder.empty() ? fs::path(soil.name).stem().string() : soil.folder.string();
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.'; }, '-'
    );
    return fmt::format("{:03}-{}", number + 1, name);
}

bool names_picture(const fs::path& output) {
    return output.extension() == ".pdf" || output.extension() == ".svg" || output.extension() == ".png";
}

/// Where the page of `--page` goes: as specified, or next to the file that it shows.
fs::path page_file(const AssessVerb& verb) {
    if (!verb.output.empty()) {
        const fs::path given = verb.output;
        return given.extension() == ".html" || given.extension() == ".htm" ? given : given / "assess.html";
    }
    const bool has_one_name = verb.files.size() == 1 && verb.files.front() != "-";
    return has_one_name ? fs::path(verb.files.front()).stem().string() + "-stability.html" : std::string("assess.html");
}

int AssessVerb::act(const CommandLine& line, const Console& console) const {
    if (shows_reading) {
        return show_readings(files, sample, reading, console);
    }
    if (!output.empty()) {
        job::require_outside_runs(output);
    }
    const stability::AssessSpec spec = spec_of(*this);
    json remarks = json::array(), list = json::array();
    FailedFiles failed(files.size());
    std::vector<MeasuredSoil> measured = read_all(*this, spec, console, remarks, failed);
    std::vector<job::AssessedSoil> soils = assess_all(measured, console, failed);
    if (soils.empty()) {
        console.document(json_text({{"soils", list}, {"remarks", remarks}, {"errors", failed.errors()}}));
        return failed.code();
    }
    const std::string& first_file = measured.front().file;
    if (!filter.empty()) {
        add_filter(*this, console, remarks, soils);
    }
    if (!filter.empty() && soils.size() == 1 && !of_case(first_file)) {
        const std::string of_sample =
            filter_sample.empty() ? "" : fmt::format(" {} {}", filter_sample_flag, shell_word(filter_sample));
        const std::string advice = advise_stack(
            soils.front().measured, soils.front().filter->measured,
            fmt::format("{} --filter {}{}", base_words(first_file), shell_word(filter), of_sample)
        );
        if (!advice.empty()) {
            console.talk(advice);
        }
    }
    const bool are_many = soils.size() > 1, is_picture = !wants_page && names_picture(output);
    const bool has_folder = !output.empty() && !wants_page && !is_picture;
    const auto& seepage = measured.front().spec.seepage;
    std::string text = are_many ? job::matrix_text(soils, seepage)
                                : job::text_of(soils.front(), measured.front().spec, terminal_width());
    for (std::size_t k = 0; k < soils.size(); ++k) {
        list.push_back(job::soil_json(soils[k], measured[k].spec));
        if (has_folder) {
            const fs::path folder = are_many ? fs::path(output) / folder_of(soils[k], k) : fs::path(output);
            const std::string page =
                write_soil_page(soils[k], measured[k].spec, list.back(), folder, line.typed).string();
            list.back()["written"] = page;
            text += are_many ? "" : "\n" + page;
        }
    }
    json document{{"soils", list}, {"remarks", remarks}};
    failed.add_to(document);
    if (are_many) {
        document["matrix"] = job::matrix_json(soils);
        if (has_folder) {
            text += "\n" + write_overlay_page(soils, document["matrix"], output, line.typed).string();
        }
    }
    if (is_picture) {
        draw_curves(soils, output);
        document["written"] = output;
        text += "\n" + output;
    }
    if (wants_page) {
        const fs::path page = page_file(*this);
        write_playground(page, soils, seepage, list);
        document["page"] = page.string();
        text += "\n" + page.string();
    }
    console.result(text);
    console.talk(next_step(first_file, soils, spec));
    console.document(json_text(document));
    return failed.code();
}

} // namespace

MadeVerb make_assess_verb() {
    return std::make_unique<AssessVerb>();
}

} // namespace suffuse::apps
