// Rows of the schema: stages with water, and those that take fines out.

#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema_row.hpp"
#include "suffuse/erosion/migrate_spec.hpp"
#include "suffuse/erosion/spec.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace suffuse::casefile::detail {

namespace {

/// Where what is left finds its new equilibrium.
Key resettling_pace(const char* where) {
    return ratio(
        where, "inertial_number", {1e-6, 1e-2, false, false},
        "Sets the largest strain rate at which what is left settles under the stresses held; a skeleton that collapses "
        "ends the denser the slower it is pressed."
    );
}

/// `what` is done with a flow that is resolved.
std::vector<Key> solver_rows(const std::string& stage, const std::string& what) {
    Key solver = choice(
        stage, "solver", names::words_of(names::solver),
        "network: of pores and throats; resolved: between the grains themselves, on a grid; auto: resolved where the "
        "network is known to fail (fewer than 50 fines, at most 1 % of them, a permeability that they raise, large "
        "overlaps, or channels). The result says which, and `known_error`."
    );
    solver.default_text = "\"network\""; // not written, see solver_fields
    Key tolerance = ratio(
        stage, "resolve_tolerance", {1e-10, 1e-2, false, false},
        "The resolved flow is iterated until the error of its permeability is this part of it; forces are off by about "
        "its root."
    );
    tolerance.default_text = "1e-4"; // not written either
    return {
        solver,
        count(
            stage, "resolve", {4, 200, false, false},
            what + "so many boxes of the grid across the Sauter diameter; 12 is usual. Minutes and gigabytes for "
                   "10,000 grains; see `plan`. By default the flow is not resolved."
        ),
        tolerance,
    };
}

/// A key of a probe of fines that have weight. It is not written where they have none: its default stands here.
Key weighed(const std::string& stage, const char* name, Range range, double otherwise, const char* text) {
    Key key = ratio(stage, name, range, text);
    key.default_text = fmt::format("{}", otherwise);
    return key;
}

std::vector<Key> weighed_rows(const std::string& stage) {
    const erosion::WeighedMotion usual;
    return {
        weighed(
            stage, "hold_at_most", {4, 1e6, false, false}, usual.hold_at_most,
            "With [gravity]: a gradient is held until motion ends, and no longer than this, in units of the time in "
            "which the median fine grain falls half its diameter. Once a tenth of the fines' mass is mobile, a rise by "
            "0.1 takes a fifth of it at most. Results mark where motion had not ended."
        ),
        weighed(
            stage, "fluid_drag", {0.01, 100, false, false}, usual.fluid_drag,
            "With [gravity]: a factor on the viscous drag that slows fines down while they move."
        ),
        weighed(
            stage, "moved", {0.01, 10, false, false}, usual.moved,
            "With [gravity]: how far along the flow fines have moved, in their diameters, that count as mobile."
        ),
        weighed(
            stage, "softness", {0, 0.05, true, true}, usual.softness,
            "With [gravity]: the overlap over the radius by which weight presses two equal fines together, at most. It "
            "sets the factor K by which weight and seepage are scaled up; steps grow as 1/sqrt(softness)."
        ),
    };
}

std::vector<Key> probe_rows(const std::string& stage) {
    const std::string detached = stage + ".detached";
    std::vector<Key> rows = {
        direction(stage, "Where the water goes: grad p = -i rho_w g direction."),
        choice(
            stage, "hold", names::words_of(names::hold),
            "Grains that stay fixed while the forces act: the paper holds the coarse ones."
        ),
        count(stage, "ramp", from_one, "Steps from no force to the full force; not with [gravity]."),
        count(
            stage, "watch", {10, 1e15, false, false},
            "Steps at the full force; the paper takes 1000; not with [gravity]."
        ),
        ratio(
            stage, "probe_unbalanced_force", above_zero,
            "The probe starts from the equilibrium relaxed to this at constant volume; not with [gravity]."
        ),
        count(
            stage, "relax_limit", from_one,
            "Steps of that relaxation after which the floor reached is taken and reported; not with [gravity]."
        ),
        table(stage, "detached", "Which fines count as detachable; not with [gravity], where weight decides."),
        choice(
            detached, "by", names::words_of(names::detach_by),
            "The paper's velocity rule, or its announced successor, displacement along the drag."
        ),
        choice(
            detached, "rule", names::words_of(names::velocity_rule),
            "Velocity rule: rising over every tenth of the watch and ending above a share of free flight; rising only; "
            "or above a speed."
        ),
        other(
            detached, "over",
            "0.5 (share of free flight), \"1e-5 m/s\" (rule \"above\"), or \"0.1 d\" (displacement, in diameters)",
            "What the rule compares with."
        ),
        ratio(
            detached, "noise_quantile", open_share,
            "Quantile of the speeds of the twin without fluid that is reported as its noise; no grain is judged by it."
        ),
    };
    append(rows, weighed_rows(stage));
    append(
        rows,
        solver_rows(stage, "Resolves the flow that gives the forces and permeabilities, where the network does not: ")
    );
    return rows;
}

/// A key that may change from pass to pass.
Key a_pass(Key key) {
    key.form = value_text(key) + ", or a list of them, one a pass";
    return key;
}

std::vector<Key> with_lists(std::vector<Key> rows, const std::vector<std::string>& names) {
    for (Key& key : rows) {
        if (key.table == "stage.erode" && std::ranges::find(names, key.name) != names.end()) {
            key = a_pass(std::move(key));
        }
    }
    return rows;
}

std::vector<Key> detach_rows() {
    Key gradients = list_of(ratio(
        "stage.detach", "gradients", from_zero,
        "Hydraulic gradients to probe; nothing is removed. With [gravity] they rise, and { up_to = 1.2, steps = 24 } "
        "is "
        "the default."
    ));
    gradients.form = "a list, each a ratio, at least 0; or { up_to = 1.2, steps = 24 }, equal steps to the last";
    std::vector<Key> rows = {
        gradients,
        required(ratio("stage.detach.gradients", "up_to", above_zero, "The last gradient.")),
        required(count("stage.detach.gradients", "steps", {1, 1000, false, false}, "Steps up to it, all equal.")),
        ratio(
            "stage.detach", "asked_gradient", above_zero,
            "With [gravity]: the gradient that the soil has to bear. Results give the factor of safety against it."
        ),
    };
    append(rows, probe_rows("stage.detach"));
    return rows;
}

std::vector<Key> migrate_rows() {
    const char* const stage = "stage.migrate";
    return {
        required(list_of(ratio(
            stage, "gradients", above_zero,
            "Hydraulic gradients, applied one after the other. Each is held until so few fines move (`still`). In "
            "`layers` they are of the base before it moves; the head that gives them is then kept."
        ))),
        direction(stage, "Where the water goes: grad p = -i rho_w g direction."),
        quantity(
            stage, "exit", dimension::length, above_zero,
            "A fine grain that crosses this plane has left: its distance along the flow from where the water enters "
            "the cell, or the base of a stack. By default a grain leaves after one cell length along the flow, a base "
            "grain within the largest filter grain of the filter's end."
        ),
        choice(
            stage, "skeleton", names::words_of(names::skeleton),
            "held: coarse grains, and fines that carry the skeleton's forces, do not move. moves: they are held while "
            "fines "
            "travel; after each gradient the skeleton finds a new equilibrium under its stresses, as in `erode`."
        ),
        quantity(
            stage, "hold_at_most", dimension::time, above_zero,
            "A gradient is held no longer, in the soil's own time. Results mark where motion had not ended."
        ),
        ratio(stage, "still", open_share, "Share of the fines' mass that may still move when a hold ends."),
        quantity(
            stage, "still_for", dimension::time, above_zero,
            "Over this time a grain that moves goes further than a tenth of its diameter."
        ),
        ratio(
            stage, "softness", {0, 0.02, true, false},
            "The overlap over the radius by which the load of 95 % of the fines presses two equal ones together. "
            "Contacts are as much softer; forces and time are real. Steps grow as its root."
        ),
        quantity(
            stage, "friction", dimension::angle, friction_angle,
            "Contact friction angle while fines travel; that of the sample unless said."
        ),
        ratio(
            stage, "with_water", {0, 1, true, true},
            "A grain whose velocity relative to the water is below this share of the water's goes with it: it takes "
            "from the flow what it feels of it, and is no obstacle."
        ),
        ratio(
            stage, "solve_after", {0, 2, true, false},
            "The flow is solved anew when 1 % of the fines' mass has moved so far, in diameters, or has begun or "
            "ceased to go with the water."
        ),
        quantity(
            stage, "feed", dimension::density, above_zero,
            "Mass of fines that each volume of water brings to the face where it enters the cell. Their sizes are "
            "those of the sample's fines. Nothing unless said."
        ),
        quantity(stage, "time_at_most", dimension::time, above_zero, "Of all holds together; no limit unless said."),
        count(
            stage, "steps_at_most", from_one,
            "Time steps, those before the flow counted: at the limit the hold ends. No limit unless said."
        ),
    };
}

} // namespace

std::vector<Key> erosion_rows() {
    std::vector<Key> rows = {
        required(
            ratio("stage.flow", "gradient", any, "Hydraulic gradient i, also as head over length: \"12 m / 30 m\".")
        ),
        direction("stage.flow", "Where the water goes: grad p = -i rho_w g direction."),
        flag("stage.flow", "tensor", "Solves three directions and reports the permeability tensor."),
    };
    append(
        rows,
        solver_rows(
            "stage.flow", "Solves the flow a second time, between the grains themselves, in addition to the network's: "
        )
    );
    append(rows, detach_rows());
    append(
        rows,
        {
            count(
                "stage.erode", "passes", {1, 10'000, false, false},
                "Passes of flow, probe, extraction and new equilibrium, at most."
            ),
            flag("stage.erode", "until_nothing_leaves", "Goes on beyond `passes` until nothing more leaves."),
            table(
                "stage.erode", "until_eroded",
                "No pass after the one by whose end so much has left; `passes` and what else ends the stage still do."
            ),
            required(ratio("stage.erode.until_eroded", "share", {0, 1, true, false}, "Mass to leave.")),
            choice(
                "stage.erode.until_eroded", "of", names::words_of(names::eroded_of),
                "Of which mass before the first pass: of the fines (unless said), or of all grains."
            ),
            a_pass(ratio(
                "stage.erode", "gradient", above_zero,
                "Hydraulic gradient i, also as head over length: \"12 m / 30 m\"; a list has one a pass, the last for "
                "all that follow."
            )),
        }
    );
    append(rows, with_lists(probe_rows("stage.erode"), {"hold", "detached"}));
    append(
        rows,
        {
            table(
                "stage.erode", "passes_constriction",
                "Which detachable grains leave: those smaller than this constriction of the coarse skeleton, or those "
                "that get through with the water."
            ),
            choice(
                "stage.erode.passes_constriction", "size", names::words_of(names::constriction_size),
                "Mean (the paper's), median (or d50, the same), d35; the widest path along the flow; the flow path: "
                "constrictions that the grain meets on its way with the water, between all grains that stay, and where "
                "it lodges if held; or none: every detachable grain leaves."
            ),
            choice(
                "stage.erode.passes_constriction", "of", names::words_of(names::constrictions_of),
                "Whose constrictions; a flow path includes those of all grains that stay."
            ),
            choice(
                "stage.erode.passes_constriction", "merge", names::words_of(names::void_merge),
                "Which neighboring pores are one void, so that no constriction lies between them: none (each facet of "
                "the triangulation counts, as in the reference), those where the center of the void sphere of one lies "
                "in that of the other, or those whose void spheres overlap. Of no effect on the two paths."
            ),
            quantity(
                "stage.erode.passes_constriction", "distance", dimension::length, above_zero,
                "Flow path: how far along the flow a grain has to get to leave; the cell's length along it unless said."
            ),
            table(
                "stage.erode", "forced",
                "Forced removal, whatever probe and constrictions say: fines with few contacts leave."
            ),
            count(
                "stage.erode.forced", "max_contacts", {0, 1000, false, false},
                "Fines with at most this many contacts leave."
            ),
            ratio(
                "stage.erode", "max_strain", {0, 2, true, false},
                "Strain of an axis in one pass beyond which the skeleton counts as failed; the erosion then ends."
            ),
            resettling_pace("stage.erode"),
            choice(
                "stage.erode", "then", names::words_of(names::then),
                "What follows an extraction: steps without fluid until [balance] holds."
            ),
            choice(
                "stage.remove", "grains", names::words_of(names::removed_fines),
                "Which grains are removed without water: all fines, those with fewer than two contacts, or those with "
                "at least two. The rest comes to rest at constant volume, then under the stresses held before."
            ),
            ratio(
                "stage.remove", "share", {0, 1, true, false},
                "How much of their mass, as it is when the stage begins, to within half a grain."
            ),
            choice(
                "stage.remove", "order", names::words_of(names::removal_order),
                "Which grains are removed first if not all are removed at once: by chance, by diameter, by the mean "
                "stress in the grain, or by number of contacts; among equals the seed decides."
            ),
            count(
                "stage.remove", "passes", {1, 10'000, false, false},
                "Equal parts in which they are removed, each followed by a new equilibrium, after which stresses and "
                "contacts are measured again."
            ),
            ratio(
                "stage.remove", "max_strain", {0, 2, true, false},
                "Strain of an axis in one pass beyond which the skeleton counts as failed; the stage then ends."
            ),
            resettling_pace("stage.remove"),
        }
    );
    append(rows, migrate_rows());
    return rows;
}

} // namespace suffuse::casefile::detail
