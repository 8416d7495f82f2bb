// Rows of the schema: top of the file, material, balance, fluid, soils, studies, output, report, presets.

#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema_row.hpp"
#include "suffuse/contact/springs.hpp"
#include "suffuse/grains/surrogate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace suffuse::casefile::detail {

namespace {

/// "linear-rolling: linear springs, adhesion; hertz-mindlin: elastic spheres"
std::string texts_of_laws(std::string_view contact::SpringWords::*what) {
    std::vector<std::string> parts;
    for (const contact::Spring& spring : contact::springs) {
        parts.push_back(fmt::format("{}: {}", spring.words.name, spring.words.*what));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

/// Names of the laws that have a key of their own.
std::string laws_with(std::string_view key) {
    return fmt::format(
        "{}", fmt::join(contact::laws_where([&](const contact::Spring& s) { return has_own(s, key); }), " and ")
    );
}

std::vector<Key> top_rows() {
    return {
        required(count("", "schema", {1, 1, false, false}, "Version of this format.")),
        text("", "title", "Title of the report."),
        text(
            "", "paper",
            "Paper that the case follows: the report judges its findings, and every figure names it. Not for your own "
            "soil."
        ),
        count(
            "", "seed", count_from_zero,
            "Seed of all random numbers: the same seed gives the same results, bit for bit."
        ),
        choice(
            "", "mode", names::words_of(names::mode),
            "Precision of the steps: reference = double throughout; fast = contact law and memory in single precision. "
            "Probes and relaxation are always of reference mode."
        ),
        text(
            "", "preset", "Preset in force unless the command line names another; \"standard\" is the case as written."
        ),
        text("", "applied_preset", "Written into resolved cases: the preset whose values they hold."),
    };
}

std::vector<Key> contact_rows() {
    return {
        quantity("grain", "density", dimension::density, above_zero, "Density of the grains."),
        choice(
            "contact", "law", names::words_of(names::law),
            fmt::format(
                "Contact law. {}. {} with Coulomb slip, rolling and twisting resistance.",
                texts_of_laws(&contact::SpringWords::summary), contact::springs.size() == 2 ? "Both" : "All"
            )
        ),
        quantity(
            "contact", "modulus", dimension::pressure, above_zero, texts_of_laws(&contact::SpringWords::modulus) + "."
        ),
        ratio(
            "contact", "shear_ratio", above_zero,
            fmt::format("Shear stiffness / normal stiffness of {}.", laws_with("shear_ratio"))
        ),
        ratio(
            "contact", "poisson", {-1, 0.5, true, false},
            fmt::format(
                "Poisson's ratio nu of the grains, of {}: shear stiffness / normal stiffness = 2 (1 - nu)/(2 - nu).",
                laws_with("poisson")
            )
        ),
        quantity(
            "contact", "friction", dimension::angle, friction_angle,
            "Contact friction angle; preparation may use another."
        ),
        ratio("contact", "rolling_stiffness", from_zero, "kr = this x ks r1 r2; 0 = no rolling resistance."),
        ratio(
            "contact", "rolling_friction", any,
            "Limit of the rolling moment: this x min(r1, r2) x normal force; negative = no limit."
        ),
        ratio("contact", "twisting_stiffness", from_zero, "ktw = this x ks r1 r2; 0 = no twisting resistance."),
        ratio(
            "contact", "twisting_friction", any, "Limit of the twisting moment, as for rolling; negative = no limit."
        ),
        ratio("contact", "damping", {0, 1, false, true}, "Local, non-viscous damping of grain forces."),
        ratio(
            "contact", "viscous_damping", from_zero,
            "Of the normal motion of each contact, as a share of the critical damping at its stiffness; 0 = none."
        ),
        table("contact", "adhesion", "Adhesion of contacts that are made from now on."),
        quantity(
            "contact.adhesion", "normal", dimension::pressure, from_zero, "Pull-off force = this x min(r1, r2)^2."
        ),
        quantity(
            "contact.adhesion", "shear", dimension::pressure, from_zero,
            "Shear strength without normal force = this x min(r1, r2)^2."
        ),
    };
}

std::vector<Key> balance_rows() {
    return {
        ratio(
            "balance", "unbalanced_force", above_zero,
            "Settled below this: mean resultant over grains with at least two contacts / mean contact force."
        ),
        ratio(
            "balance", "stress_error", above_zero,
            "Settled below this: largest error of a controlled stress / largest wanted stress."
        ),
        count("balance", "patience", from_one, "Steps in a row for which both hold before a stage counts as settled."),
        quantity("fluid", "density", dimension::density, above_zero, "Density of the pore fluid."),
        quantity("fluid", "viscosity", dimension::viscosity, above_zero, "Dynamic viscosity of the pore fluid."),
        quantity(
            "fluid", "bulk_modulus", dimension::pressure, above_zero,
            "Of undrained tests: how far the fluid in the voids can be compressed; 2.2 GPa for pure water, less with "
            "air "
            "in it. Without it the fluid is incompressible, and Skempton's B is 1."
        ),
        choice(
            "fluid", "conductance", names::words_of(names::conductance),
            "Law of the pore network's throats and of the forces on grains. bounded: within 12 % of the resolved flow "
            "for most packings; "
            "yade: "
            "as in Yade 2023.02a, for comparisons with it; too permeable where fines are few or small."
        ),
    };
}

std::vector<Key> gravity_rows() {
    Key down =
        row("gravity", "down", ValueKind::Direction,
            "Where weight points. With this table the fines of `detach`, `erode` and `migrate` have weight, less "
            "buoyancy; without it none, as in the paper. All other stages are weightless either way.");
    Key acceleration = quantity(
        "gravity", "acceleration", dimension::acceleration, above_zero,
        "Of gravity; a hydraulic gradient pulls with it, too."
    );
    acceleration.default_text = "\"9.81 m/s^2\"";
    return {required(down), acceleration};
}

std::vector<Key> preset_rows() {
    Key inertial =
        ratio("presets.*", "inertial_number", above_zero, "Replaces `inertial_number` of every triaxial stage.");
    inertial.form = "a ratio above 0, or \"strict\" (1e-4), or \"loose\" (1e-3)";
    return {
        list_of(text("presets.*", "studies", "Only these studies: the others are left out.")),
        count("presets.*", "particles", from_one, "Replaces `particles` of every study that packs its own grains."),
        count(
            "presets.*", "coarse_grains", from_one, "Replaces it in `sample_size` of every study that has such a table."
        ),
        count("presets.*", "at_least", from_one, "Replaces it in `sample_size` of every study that has such a table."),
        count("presets.*", "replicates", from_one, "Replaces `replicates` of every study."),
        inertial,
        list_of(ratio("presets.*", "fines_content", share, "Replaces the list of every sweep over `fines_content`.")),
        ratio("presets.*", "triaxial_strain", above_zero, "Replaces `strain` of every triaxial stage."),
        count("presets.*", "passes", from_one, "Replaces `passes` of every erode stage."),
        list_of(ratio("presets.*", "gradients", from_zero, "Replaces `gradients` of every detach stage.")),
        count("presets.*", "ramp", from_one, "Replaces `ramp` of every detach and erode stage."),
        count("presets.*", "watch", {10, 1e15, false, false}, "Replaces `watch` of every detach and erode stage."),
        ratio("presets.*", "probe_unbalanced_force", above_zero, "Replaces it in every detach and erode stage."),
        count("presets.*", "relax_limit", from_one, "Replaces it in every detach and erode stage."),
        ratio("presets.*", "unbalanced_force", above_zero, "Replaces it in [balance]."),
        ratio("presets.*", "stress_error", above_zero, "Replaces it in [balance]."),
        count("presets.*", "patience", from_one, "Replaces it in [balance]."),
        quantity("presets.*", "max_rate", dimension::rate, above_zero, "Replaces `max_rate` of every compact stage."),
        quantity(
            "presets.*", "hold_at_most", dimension::time, above_zero, "Replaces `hold_at_most` of every migrate stage."
        ),
    };
}

} // namespace

std::vector<Key> general_rows() {
    std::vector<Key> rows = top_rows();
    append(rows, contact_rows());
    append(rows, balance_rows());
    append(rows, gravity_rows());
    return rows;
}

std::vector<Key> soil_and_study_rows() {
    const std::string_view psd = "a CSV file; { file = \"soil.csv\", size = \"1:um\", share = \"2\" } names its "
                                 "columns as the flags of `assess` do; or { d = [\"0.1 mm\", ...], passing = [\"0 %\", "
                                 "...] }";
    Key fines_auto = choice(
        "soil.*", "fines_auto", {"kenney-lau", "none"},
        "Also reports Kenney and Lau's split into coarse and fine, without using it."
    );
    return {
        other("soil.*", "psd", psd, "Grading curve of the whole soil: columns `d [mm]`, `passing [%]` by mass."),
        list_of(quantity(
            "soil.*", "sizes", dimension::length, above_zero,
            "The finest and the coarsest size that are modeled, of a curve that extends beyond them; its ends may be "
            "open."
        )),
        table(
            "soil.*", "surrogate",
            "The soil of `psd` is too wide to simulate: two fractions stand for it, with its size ratio and its fines "
            "content."
        ),
        required(quantity(
            "soil.*.surrogate", "finer_than", dimension::length, above_zero,
            "Where the curve is split: what is smaller are the fines."
        )),
        ratio(
            "soil.*.surrogate", "size_ratio", {grains::least_size_ratio, 1e9, false, false},
            "Of the two fractions; D50 of the curve's coarse part / d50 of its fines unless given."
        ),
        ratio(
            "soil.*.surrogate", "coarse_width", {1, 1e9, true, false},
            "Largest size of the coarse fraction / its smallest; that of the curve unless given, from 1.22 to 2."
        ),
        ratio(
            "soil.*.surrogate", "fines_width", {1, 1e9, true, false},
            "Likewise of the fines; that of the curve unless given, from 1.22 to 4."
        ),
        table("soil.*", "coarse", "Coarse part of a soil of two fractions."),
        required(other("soil.*.coarse", "psd", psd, "Grading curve of the coarse part alone.")),
        other(
            "soil.*", "fines", "{ psd = ... }, { finer_than = \"0.26 mm\" }, or \"kenney-lau\"",
            "Which grains are fine: a second grading, all below a size, or Kenney and Lau's split."
        ),
        other("soil.*.fines", "psd", psd, "Grading curve of the fine part alone."),
        quantity("soil.*.fines", "finer_than", dimension::length, above_zero, "Grains smaller than this are fine."),
        ratio("soil.*", "fines_content", share, "Mass of the fine part / mass of both; for soils of two fractions."),
        fines_auto,
        ratio(
            "soil.*", "grading_tolerance", open_share,
            "Largest difference of percent passing that is accepted between the sample and its grading."
        ),
        text("study.*", "soil", "Name of a [soil.NAME]: what is packed, or which imported grains are fine."),
        count("study.*", "particles", {1, 2e9, false, false}, "Number of grains."),
        table(
            "study.*", "sample_size",
            "Instead of `particles`, for soils of two fractions: enough coarse grains or a cell wide enough, whichever "
            "takes fewer grains. `suffuse plan` says which."
        ),
        count(
            "study.*.sample_size", "coarse_grains", {1, 2e9, false, false},
            "At least so many coarse grains; of a soil of fines alone, so many fines."
        ),
        ratio(
            "study.*.sample_size", "cell_width", above_zero,
            "Or a cell so many median coarse diameters wide, at a porosity of 0.4."
        ),
        count("study.*.sample_size", "at_least", {1, 2e9, false, false}, "But never fewer grains of both fractions."),
        count(
            "study.*.sample_size", "at_most", {1, 2e9, false, false},
            "Nor more, as long as `least_coarse` coarse grains remain: many fines cost most."
        ),
        count(
            "study.*.sample_size", "least_coarse", {1, 2e9, false, false},
            "Coarse grains that `at_most` leaves, however many fines belong to them."
        ),
        other(
            "study.*", "sweep", "{ KEY = [values] }",
            "One copy of the study per value; lists multiply. KEY is `particles`, `soil`, `seed`, a key of the soil, "
            "\"stage.NAME.KEY\", or \"contact.KEY\", which then applies to all stages of the copy."
        ),
        other(
            "study.*", "rows", "a CSV file, or { KEY = [values] }",
            "Values of several keys that belong together, as parameters of one sample of a posterior: one copy of the "
            "study per row. Keys as in `sweep`; in a file they are the headings. `sweep` may choose among them: { row "
            "= "
            "[1, 5] }."
        ),
        table(
            "study.*", "refine",
            "Adds values to a sweep when its own have been run, on both sides of the extreme of a measured curve."
        ),
        required(text("study.*.refine", "key", "The key of `sweep` that is refined.")),
        choice("study.*.refine", "around", names::words_of(names::extreme), "Where the curve is lowest, or highest."),
        required(text(
            "study.*.refine", "of",
            "A number of stage.json, as in void_ratio or contact_share.LS; its mean over the replicates is the curve."
        )),
        required(list_of(text("study.*.refine", "at", "Stages whose curves are examined, each separately."))),
        count("study.*.refine", "add", {1, 100, false, false}, "Values between the extreme and each of its neighbors."),
        count("study.*", "replicates", {1, 10'000, false, false}, "Copies of the study with different seeds."),
        other("study.*", "stage", "[[study.NAME.stage]]", "What is done, one stage after the other."),
    };
}

std::vector<Key> output_rows() {
    std::vector<Key> rows = {
        list_of(choice(
            "output", "formats", names::words_of(names::formats),
            "Files of each state: vtp (ParaView), xyz (OVITO), csv (tables of many rows for every stage)."
        )),
        other(
            "output", "snapshots", "\"per-stage\", \"none\", or { every = \"1 %\" }",
            "When pictures of the state (vtp, xyz) are written: at the end of each stage, never, or also each time the "
            "largest strain of a stage passes a multiple."
        ),
        ratio("output.snapshots", "every", open_share, "Strain between two snapshots."),
        quantity("output", "checkpoint", dimension::time, above_zero, "Wall-clock time between checkpoints."),
        table("output", "histories", "How often histories are sampled."),
        count("output.histories", "every", from_one, "Steps between two rows, where a stage's `record` does not say."),
        text("report", "project", "Title page of the printed report: its subject."),
        text("report", "author", "Title page of the printed report: the person responsible."),
        list_of(
            text("report", "figures", "Figures of the report: \"paper\", \"own\", or single ones such as \"figure-9\".")
        ),
        choice(
            "report", "psd_axis", names::words_of(names::size_axis),
            "Grain sizes from small to large, or reversed (the American habit)."
        ),
        choice(
            "report", "dilation", names::words_of(names::dilation),
            "Which way dilation is drawn; compression stays positive in all numbers."
        ),
        other(
            "report", "overlay", "{ figure-2 = \"data/points.csv\" }",
            "CSV files of measured points to draw as markers."
        ),
    };
    append(rows, preset_rows());
    return rows;
}

} // namespace suffuse::casefile::detail
