#include "apps/verb_flags.hpp"

#include "suffuse/base/units.hpp"
#include "suffuse/io/text_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/command_line.hpp"
#include <cctype>
#include <limits>
#include <type_traits>

namespace suffuse::apps {
namespace {

const std::string case_text = "the case file";
const std::string folder_text = "the folder of a run";
const std::string packing_text =
    "grains: CSV with x,y,z,r in meters, Yade's text, LAMMPS data or dump, extended XYZ, .vtp";
const std::string cell_text =
    "edges of its cell in meters, or nine numbers, its matrix by rows; the file's own unless given";
const std::string format_text = "csv, yade, xyz, lammps, dump or vtp; by the file's ending unless given";

/// Empty where `text` is a number from `least` to `most`, else what it should be: CLI11's own words have all the digits
/// of the largest number there is.
template <class T>
std::string complaint_of_range(const std::string& text, T least, T most, const std::string& expected) {
    const std::optional<T> value = io::number_of<T>(text);
    const bool is_good = value && *value >= least && *value <= most;
    return is_good ? "" : fmt::format("{} is not {}", text, expected);
}

template <class T>
CLI::Validator number_in(T least, T most) {
    const char* const kind = std::is_integral_v<T> ? "a whole number" : "a number";
    const std::string expected = fmt::format("{} from {} to {}", kind, least, most);
    return CLI::Validator(
        [=](std::string& text) { return complaint_of_range(text, least, most, expected); }, std::string()
    );
}

/// A ratio as a case has them: a bare number, one with %, or a quotient. "30%" and "3m/10m" become "0.3".
CLI::Validator ratio_in(double least, double most) {
    const std::string expected = most < std::numeric_limits<double>::max()
                                     ? fmt::format("a number from {} to {}, or as in {:.4g}%", least, most, 50 * most)
                                     : fmt::format("a number of {} or more, or as in 30%", least);
    return CLI::Validator(
        [=](std::string& text) {
            try {
                text = fmt::format("{}", parse_quantity(text, dimension::none));
            } catch (const UnitError& problem) {
                const bool is_number = !text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) != 0;
                return is_number ? fmt::format("{}; {}", problem.what(), problem.help)
                                 : fmt::format("{} is not {}", text, expected);
            }
            return complaint_of_range(text, least, most, expected);
        },
        std::string()
    );
}

CLI::Validator number_from_zero() {
    return CLI::Validator(
        [](std::string& text) {
            return complaint_of_range(text, 0.0, std::numeric_limits<double>::max(), "a number of 0 or more");
        },
        std::string()
    );
}

void add_everywhere(CLI::App& app, CommandLine& line) {
    app.add_flag("-q,--quiet", line.quiet, "say nothing but results and errors");
    app.add_flag("-v,--verbose", line.verbose, "say more");
    app.add_flag("--json", line.json, "one JSON document on standard output");
    app.add_option("--color", line.color_word, "auto, always or never; NO_COLOR is heeded")->type_name("WHEN");
}

CLI::Option* add_subject(CLI::App& verb, CommandLine& line, const std::string& name, const std::string& text) {
    return verb.add_option(name, line.subject, text)->required();
}

void add_case_changes(CLI::App& verb, CommandLine& line) {
    verb.add_option("--preset", line.preset, "size of the job, one of the case's [presets.*]")->type_name("NAME");
    verb.add_option("--set", line.overrides, "change one value of the case; may be repeated")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    verb.add_option("--study", line.studies, "this study of the case alone; may be repeated")
        ->type_name("NAME")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
}

void add_threads(CLI::App& verb, CommandLine& line) {
    verb.add_option("-j,--threads", line.threads, "threads; all cores unless given. Results do not depend on it")
        ->type_name("N")
        ->check(number_in(1, 1024));
}

void add_cache(CLI::App& verb, CommandLine& line) {
    CLI::Option* cache = verb.add_option(
        "--cache", line.cache, "folder where stages are kept and found again; suffuse-cache beside the run unless given"
    );
    cache->type_name("DIR");
    verb.add_flag("--no-cache", line.no_cache, "compute every stage, and keep none")->excludes(cache);
}

void add_until(CLI::App& verb, CommandLine& line) {
    verb.add_option("--until", line.until, "end each sample with this stage")->type_name("STAGE");
}

void add_limits(CLI::App& verb, CommandLine& line) {
    add_until(verb, line);
    verb.add_option("--time-limit", line.time_limit, "save and stop after this wall time, as in 90min or 2h")
        ->type_name("TIME");
}

void add_run_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* run = app.add_subcommand("run", "run a case and write its report");
    add_subject(*run, line, "CASE", case_text);
    add_threads(*run, line);
    run->add_option("-o,--output", line.output, "folder of the run; runs/NAME-0001 and so on unless given")
        ->type_name("DIR");
    add_case_changes(*run, line);
    add_cache(*run, line);
    add_limits(*run, line);

    CLI::App* resume = app.add_subcommand("resume", "go on with a run that was stopped, to the same bits");
    add_subject(*resume, line, "DIR", folder_text);
    add_threads(*resume, line);
    add_cache(*resume, line);
    add_limits(*resume, line);

    resume->add_option("--sample", line.sample, "this sample alone, beside others; as in fines/fc=20/rep=1")
        ->type_name("NAME");

    CLI::App* report = app.add_subcommand("report", "write the report of a run again, without computing");
    add_subject(*report, line, "DIR", folder_text);

    CLI::App* figures = app.add_subcommand("figures", "draw the figures of a run as files, for a manuscript");
    add_subject(*figures, line, "DIR", folder_text);
    figures->add_option("--format", line.format, "svg, png or pdf; svg unless given")
        ->type_name("NAME")
        ->check(CLI::IsMember({"svg", "png", "pdf"}));
    figures->add_option("--figure", line.figures, "only this one, as in 9 or own-rules; may be repeated")
        ->type_name("N")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    figures->add_option("-o,--output", line.output, "folder for the files; the run's figures/ unless given")
        ->type_name("DIR");

    CLI::App* compare = app.add_subcommand("compare", "what differs between two runs, or from the paper's findings");
    add_subject(*compare, line, "DIR", folder_text);
    compare->add_option("OTHER", line.other, "the folder of another run");
    compare
        ->add_option(
            "--tolerance", line.tolerance, "up to which two numbers count as the same, as in 1%; 0 unless given"
        )
        ->type_name("SHARE");
    compare->add_flag("--paper", line.paper, "with what the paper found, instead of another run");

    CLI::App* verify = app.add_subcommand("verify", "whether a run's files are whole and as they were when it ended");
    add_subject(*verify, line, "DIR", folder_text);

    CLI::App* watch = app.add_subcommand("watch", "follow a run from another terminal, or tell how it ended");
    add_subject(*watch, line, "DIR", folder_text);
}

void add_sweep_verb(CLI::App& app, CommandLine& line) {
    CLI::App* sweep = app.add_subcommand("sweep", "run the samples of a case as tasks of a cluster, and gather them");
    CLI::Option* subject =
        sweep->add_option("CASE", line.subject, "the case file, or the folder of a run whose rest is to be run");
    CLI::Option* emit =
        sweep->add_option("--emit", line.emit, "write the tasks: slurm, or parallel (GNU parallel, sh)");
    emit->type_name("FORM")->check(CLI::IsMember({"slurm", "parallel"}))->needs(subject);
    CLI::Option* collect = sweep->add_option("--collect", line.collect, "gather what the tasks left in the folder DIR");
    collect->type_name("DIR")->excludes(emit)->excludes(subject);
    sweep->add_option("-o,--output", line.output, "folder of the run; runs/NAME-0001 and so on unless given")
        ->type_name("DIR");
    sweep->add_option("-j,--threads", line.threads, "threads of each task, 1 unless given")
        ->type_name("N")
        ->check(number_in(1, 1024));
    sweep
        ->add_option(
            "--time-limit", line.time_limit, "wall time of each task, as in 2h; what is not done goes on later"
        )
        ->type_name("TIME");
    add_case_changes(*sweep, line);
    add_cache(*sweep, line);
}

void add_cache_verb(CLI::App& app, CommandLine& line) {
    CLI::App* cache = app.add_subcommand("cache", "what the cache of stages holds; limit or empty it");
    cache->add_option("DIR", line.subject, "folder of the cache; runs/suffuse-cache unless given");
    CLI::Option* limit =
        cache->add_option("--limit", line.cache_limit, "most that it may hold from now on, in GB; 10 at first");
    limit->type_name("GB")->check(number_from_zero());
    cache->add_flag("--clear", line.clear, "drop all that it holds")->excludes(limit);
}

void add_case_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* make = app.add_subcommand("new", "write a commented case and its data to start from");
    make->add_option(
        "DIR", line.subject, "folder to write it to; the name of the template or of the curve unless given"
    );
    CLI::Option* from = make->add_option("--from", line.from, "an example to start from");
    from->type_name("NAME");
    CLI::Option* psd = make->add_option(
        "--psd", line.psd, "grading curve of a soil of yours: CSV with the columns d [mm], passing [%]"
    );
    psd->type_name("FILE")->excludes(from);
    make->add_option("--sizes", line.sizes, "with --psd: the part of the curve to model, as in 0.1mm,4mm")
        ->type_name("FROM,TO")
        ->needs(psd);
    make->add_option(
            "--particles", line.particles, "with --psd: grains of the preset quick; as few as will do unless given"
    )
        ->type_name("N")
        ->check(number_in<std::int64_t>(1, 10'000'000))
        ->needs(psd);
    make->add_option("--pressure", line.pressure, "with --psd: the effective stress on the soil; 100kPa is assumed")
        ->type_name("P")
        ->needs(psd);
    make->add_option(
            "-i,--gradient", line.seepage_gradient,
            "with --psd: the hydraulic gradient of the seepage, as in 0.4 or 12m/30m; 0.05 is assumed"
    )
        ->type_name("I")
        ->transform(ratio_in(0, std::numeric_limits<double>::max()))
        ->needs(psd);

    CLI::App* check = app.add_subcommand("check", "read a case and tell all that is wrong with it");
    add_subject(*check, line, "CASE", case_text);
    add_case_changes(*check, line);

    CLI::App* plan = app.add_subcommand("plan", "what a case would cost: steps, time, memory, disk");
    add_subject(*plan, line, "CASE", case_text);
    add_threads(*plan, line);
    add_case_changes(*plan, line);
    add_cache(*plan, line);
    add_until(*plan, line);

    CLI::App* explain = app.add_subcommand(
        "explain",
        "one screen on a key, a table, a verb of a stage, a code, a figure, a finding, a criterion, or the conventions"
    );
    add_subject(*explain, line, "WORD", "as in contact.modulus, erode, E310, figure-9, kezdi-1979, conventions");

    app.add_subcommand("schema", "every key that a case may have, as Markdown");
}

void add_packing_options(CLI::App& verb, CommandLine& line) {
    verb.add_option("--packing", line.packing, packing_text)->type_name("FILE")->required();
    verb.add_option("--cell", line.cell, cell_text)->type_name("LX,LY,LZ");
}

void add_bench_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* bench = app.add_subcommand("bench", "measure the speed on a packing of yours");
    CLI::App* step = bench->add_subcommand("step", "settle a packing at 100 kPa, then time slow shear");
    step->add_option("--steps", line.steps, "steps that are timed, 2000 unless given")
        ->type_name("N")
        ->check(number_in(1, 1'000'000'000));
    step->add_option("--time-step", line.time_step, "in seconds; 4.1e-8 unless given")->type_name("DT");
    step->add_option("--mode", line.mode, "of the timed steps: reference or fast; reference unless given")
        ->type_name("NAME")
        ->check(CLI::IsMember({"reference", "fast"}));
    CLI::App* flow = bench->add_subcommand("flow", "time each part of a flow solution");
    flow->add_option("--gradient", line.gradient, "hydraulic gradient along x, 0.05 unless given")->type_name("I");
    for (CLI::App* verb : {step, flow}) {
        add_packing_options(*verb, line);
        add_threads(*verb, line);
        verb->add_option("--replicate", line.replicate, "copies of the packing along each axis")
            ->type_name("N")
            ->check(number_in(1, 30));
        verb->callback([verb, &line] { line.bench = verb->get_name(); });
    }
}

void add_packing_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* import = app.add_subcommand("import", "look at a packing from elsewhere, and write it in another format");
    add_subject(*import, line, "FILE", packing_text);
    import->add_option("--cell", line.cell, cell_text)->type_name("LX,LY,LZ");
    import->add_option("--unit", line.unit, "of the lengths in the file, as in mm; m unless given")->type_name("UNIT");
    import->add_option("-o,--output", line.output, "file to write")->type_name("FILE");
    import->add_option("--format", line.format, format_text)->type_name("NAME");

    CLI::App* out = app.add_subcommand("export", "write the grains of a stage for other programs");
    add_subject(*out, line, "STATE", "a stage's state.h5, or the stage's folder");
    out->add_option("-o,--output", line.output, "file to write")->type_name("FILE");
    out->add_option("--format", line.format, format_text)->type_name("NAME");
}

void add_assess_verb(CLI::App& app, CommandLine& line) {
    CLI::App* assess =
        app.add_subcommand("assess", "internal stability of a soil from its grading, without simulation");
    add_subject(
        *assess, line, "FILE", "a grading: CSV with the columns d [mm], passing [%]; or a case, for all its soils"
    );
    assess->add_option("--fines", line.fines, "size below which grains count as fine; found on the curve unless given")
        ->type_name("D");
    assess
        ->add_option(
            "-i,--gradient", line.seepage_gradient, "hydraulic gradient of upward seepage, as in 0.4 or 12m/30m"
        )
        ->type_name("I")
        ->transform(ratio_in(0, std::numeric_limits<double>::max()));
    assess->add_option("--relative-density", line.relative_density, "0 loosest, 1 densest; both unless given")
        ->type_name("ID")
        ->transform(ratio_in(0, 1));
    assess->add_option("--porosity", line.porosity, "with -i; 0.40 unless given")
        ->type_name("N")
        ->transform(ratio_in(0.05, 0.95));
    assess->add_option("--density", line.density, "of the grains, with -i; 2650kg/m^3 unless given")->type_name("RHO");
    assess
        ->add_option("--alpha", line.stress_share, "with -i: mean effective stress in the fines over that of the soil")
        ->type_name("A")
        ->transform(ratio_in(0, 1));
    assess->add_flag("--coarse-fabric", line.coarse_fabric, "D60/D10 of the coarse part decides how far to look at F");
    assess->add_option("-o,--output", line.output, "folder for a page, its figures and numbers")->type_name("DIR");
}

void add_shell_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* completions = app.add_subcommand("completions", "a script by which a shell completes verbs and flags");
    add_subject(*completions, line, "SHELL", "bash, zsh or fish");
    app.add_subcommand("man", "the man page, in roff");
}

} // namespace

void add_verbs(CLI::App& app, CommandLine& line) {
    add_everywhere(app, line);
    add_run_verbs(app, line);
    add_sweep_verb(app, line);
    add_cache_verb(app, line);
    add_case_verbs(app, line);
    add_bench_verbs(app, line);
    add_packing_verbs(app, line);
    add_assess_verb(app, line);
    add_shell_verbs(app, line);
}

} // namespace suffuse::apps
