#include "apps/command_line.hpp"

#include "suffuse/base/spelling.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/completions.hpp"
#include "apps/help.hpp"
#include "apps/man_page.hpp"
#include <algorithm>

namespace suffuse::apps {
namespace {

const std::string case_text = "the case file";
const std::string folder_text = "the folder of a run";
const std::string packing_text =
    "grains: CSV with x,y,z,r in meters, Yade's text, LAMMPS data or dump, extended XYZ, .vtp";
const std::string cell_text =
    "edges of its cell in meters, or nine numbers, its matrix by rows; the file's own unless given";
const std::string format_text = "csv, yade, xyz, lammps, dump or vtp; by the file's ending unless given";

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
}

void add_threads(CLI::App& verb, CommandLine& line) {
    verb.add_option("-j,--threads", line.threads, "threads; all cores unless given. Results do not depend on it")
        ->type_name("N")
        ->check(CLI::Range(1, 1024));
}

void add_cache(CLI::App& verb, CommandLine& line) {
    CLI::Option* cache = verb.add_option(
        "--cache", line.cache, "folder where stages are kept and found again; suffuse-cache beside the run unless given"
    );
    cache->type_name("DIR");
    verb.add_flag("--no-cache", line.no_cache, "compute every stage, and keep none")->excludes(cache);
}

void add_limits(CLI::App& verb, CommandLine& line) {
    verb.add_option("--until", line.until, "end each sample with this stage")->type_name("STAGE");
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
        ->check(CLI::Range(1, 1024));
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
    limit->type_name("GB")->check(CLI::NonNegativeNumber);
    cache->add_flag("--clear", line.clear, "drop all that it holds")->excludes(limit);
}

void add_case_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* make = app.add_subcommand("new", "write a commented case and its data to start from");
    make->add_option("DIR", line.subject, "folder to write it to; the template's name unless given");
    make->add_option("--from", line.from, "template to start from")->type_name("NAME")->required();

    CLI::App* check = app.add_subcommand("check", "read a case and tell all that is wrong with it");
    add_subject(*check, line, "CASE", case_text);
    add_case_changes(*check, line);

    CLI::App* plan = app.add_subcommand("plan", "what a case would cost: steps, time, memory, disk");
    add_subject(*plan, line, "CASE", case_text);
    add_threads(*plan, line);
    add_case_changes(*plan, line);
    add_cache(*plan, line);

    CLI::App* explain = app.add_subcommand("explain", "one screen on a key, an error code, or the conventions");
    add_subject(*explain, line, "WORD", "as in contact.modulus, E310, conventions");

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
        ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
    step->add_option("--time-step", line.time_step, "in seconds; 4.1e-8 unless given")->type_name("DT");
    CLI::App* flow = bench->add_subcommand("flow", "time each part of a flow solution");
    flow->add_option("--gradient", line.gradient, "hydraulic gradient along x, 0.05 unless given")->type_name("I");
    for (CLI::App* verb : {step, flow}) {
        add_packing_options(*verb, line);
        add_threads(*verb, line);
        verb->add_option("--replicate", line.replicate, "copies of the packing along each axis")
            ->type_name("N")
            ->check(CLI::Range(1, 30));
        verb->callback([verb, &line] { line.bench = verb->get_name(); });
    }
}

void add_packing_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* import = app.add_subcommand("import", "look at a packing from elsewhere, and write it in another format");
    add_subject(*import, line, "FILE", packing_text);
    import->add_option("--cell", line.cell, cell_text)->type_name("LX,LY,LZ");
    import->add_option("-o,--output", line.output, "file to write")->type_name("FILE");
    import->add_option("--format", line.format, format_text)->type_name("NAME");

    CLI::App* out = app.add_subcommand("export", "write the grains of a stage for other programs");
    add_subject(*out, line, "STATE", "a stage's state.h5, or the stage's folder");
    out->add_option("-o,--output", line.output, "file to write")->type_name("FILE")->required();
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
    assess->add_option("-i,--gradient", line.seepage_gradient, "hydraulic gradient of upward seepage")
        ->type_name("I")
        ->check(CLI::NonNegativeNumber);
    assess->add_option("--relative-density", line.relative_density, "0 loosest, 1 densest; both unless given")
        ->type_name("ID")
        ->check(CLI::Range(0.0, 1.0));
    assess->add_option("--porosity", line.porosity, "with -i; 0.40 unless given")
        ->type_name("N")
        ->check(CLI::Range(0.05, 0.95));
    assess->add_option("--density", line.density, "of the grains, with -i; 2650kg/m^3 unless given")->type_name("RHO");
    assess->add_option("--alpha", line.stress_share, "with -i: mean stress of the fines over that of the soil")
        ->type_name("A")
        ->check(CLI::Range(0.0, 1.0));
    assess->add_flag("--coarse-fabric", line.coarse_fabric, "D60/D10 of the coarse part decides how far to look at F");
    assess->add_option("-o,--output", line.output, "folder for a page, its figures and numbers")->type_name("DIR");
}

void add_shell_verbs(CLI::App& app, CommandLine& line) {
    CLI::App* completions = app.add_subcommand("completions", "a script by which a shell completes verbs and flags");
    add_subject(*completions, line, "SHELL", "bash, zsh or fish");
    app.add_subcommand("man", "the man page, in roff");
}

std::vector<std::string> names_of_verbs(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(verb->get_name());
    }
    return names;
}

/// Long and short names of what an app and those above it understand.
std::vector<std::string> names_of_flags(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* level = &app; level != nullptr; level = level->get_parent()) {
        for (const CLI::Option* option : level->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                names.push_back("--" + name);
            }
        }
    }
    return names;
}

/// The verb, or verb below it, that was recognized last.
const CLI::App& innermost(const CLI::App& app) {
    const CLI::App* level = &app;
    while (!level->get_subcommands().empty()) {
        level = level->get_subcommands().back();
    }
    return *level;
}

[[noreturn]] void complain_about_extra(const CLI::App& app) {
    const CLI::App& verb = innermost(app);
    const std::vector<std::string> extra = app.remaining(true);
    const std::string word = extra.empty() ? "" : extra.front();
    const std::string help = &verb == &app ? "suffuse --help" : fmt::format("suffuse {} --help", path_of(verb));
    if (word.rfind('-', 0) == 0) {
        const std::string flag = word.substr(0, word.find('='));
        throw UsageError(
            fmt::format("unknown flag {}{}; {} lists them", shown(flag), near_hint(flag, names_of_flags(verb)), help)
        );
    }
    const std::vector<std::string> verbs = names_of_verbs(verb);
    if (!verbs.empty()) {
        throw UsageError(fmt::format("unknown verb {}{}; {} lists them", shown(word), near_hint(word, verbs), help));
    }
    throw UsageError(fmt::format("{} is one argument too many; see {}", shown(word), help));
}

Color color_of(const std::string& word) {
    if (word == "always") {
        return Color::Always;
    }
    if (word == "never") {
        return Color::Never;
    }
    if (word == "auto") {
        return Color::Auto;
    }
    throw UsageError(fmt::format("--color {}: it is auto, always or never", shown(word)));
}

std::string quoted(const std::string& word) {
    const bool is_plain =
        !word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+%@") ==
            std::string::npos;
    if (is_plain) {
        return word;
    }
    std::string text = "'";
    for (const char c : word) {
        text += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return text + "'";
}

/// `suffuse my/case.toml` runs the case.
std::vector<std::string> with_verb(std::vector<std::string> words) {
    constexpr std::string_view ending = ".toml";
    if (!words.empty() && words.front().size() > ending.size() && words.front().ends_with(ending)) {
        words.insert(words.begin(), "run");
    }
    return words;
}

void parse(CLI::App& app, std::vector<std::string> words, CommandLine& line) {
    std::reverse(words.begin(), words.end()); // as CLI11 wants them
    try {
        app.parse(words);
    } catch (const CLI::CallForVersion&) {
        line.text = version_text();
    } catch (const CLI::CallForHelp&) {
        const CLI::App& verb = innermost(app);
        line.text = &verb == &app ? overview(app) : help_on(verb);
    } catch (const CLI::ExtrasError&) {
        complain_about_extra(app);
    } catch (const CLI::ParseError& error) {
        const CLI::App& verb = innermost(app);
        throw UsageError(
            fmt::format("{}; see suffuse {}--help", shown(error.what()), &verb == &app ? "" : path_of(verb) + " ")
        );
    }
}

} // namespace

std::string shown(const std::string& word) {
    constexpr std::size_t most = 200;
    std::string text = word.substr(0, most);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?'
    );
    return word.size() > most ? text + "..." : text;
}

std::string near_hint(const std::string& word, const std::vector<std::string>& known) {
    const auto nearest = nearest_word(word, known);
    return nearest ? fmt::format("; a similar one exists: {}", *nearest) : "";
}

CommandLine read_command_line(int argc, const char* const* argv) {
    CommandLine line;
    const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    line.typed = "suffuse";
    for (const std::string& word : words) {
        line.typed += " " + quoted(word);
    }
    CLI::App app;
    app.fallthrough();
    app.set_version_flag("--version", std::string(), "which program this is");
    add_everywhere(app, line);
    add_run_verbs(app, line);
    add_sweep_verb(app, line);
    add_cache_verb(app, line);
    add_case_verbs(app, line);
    add_bench_verbs(app, line);
    add_packing_verbs(app, line);
    add_assess_verb(app, line);
    add_shell_verbs(app, line);
    parse(app, with_verb(words), line);
    if (!line.text.empty()) {
        return line;
    }
    if (app.get_subcommands().empty()) {
        line.text = overview(app);
        return line;
    }
    line.verb = app.get_subcommands().front()->get_name();
    if (line.verb == "bench" && line.bench.empty()) {
        throw UsageError("bench what? suffuse bench step, or suffuse bench flow; suffuse bench --help says more");
    }
    if (line.verb == "sweep" && line.emit.empty() && line.collect.empty()) {
        throw UsageError(
            "sweep: --emit slurm or --emit parallel with a case, or --collect DIR; suffuse run CASE runs all "
            "samples on this machine"
        );
    }
    line.color = color_of(line.color_word);
    if (line.verb == "completions" || line.verb == "man") { // the table of verbs is here, and all there is to say
        const std::vector<VerbRow> table = command_table(app);
        line.text = line.verb == "man" ? man_page(table) : completions_for(line.subject, table);
        line.verb.clear();
    }
    return line;
}

} // namespace suffuse::apps
