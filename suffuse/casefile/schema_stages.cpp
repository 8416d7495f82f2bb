// Rows of the schema: stages that make samples and move them.

#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema_row.hpp"

#include <fmt/format.h>

namespace suffuse::casefile::detail {

namespace {

std::vector<Key> common_rows() {
    return {
        required(text("stage", "name", "Name of the stage, unique in its study: its folder, and what `from` refers to.")
        ),
        required(choice("stage", "do", names::words_of(names::verbs), "What the stage does.")),
        text("stage", "from", "Earlier stage whose end state this one starts from; without it, the stage before."),
        table("stage", "record", "How often the stage's history is sampled."),
        count("stage.record", "every", from_one, "Steps between two rows of the history."),
        flag("stage", "restore", "The stage after this one starts where this one started."),
        list_of(choice(
            "stage", "measure", names::words_of(names::measures),
            "What to gather under `measured` in stage.json: numbers that the stage reports anyway, and permeability, "
            "constrictions and grading of its end state, which are measured only on request. stress-strain belongs to "
            "triaxial and plane-strain, skempton-b to triaxial, cyclic and stiffness, flow to flow and erode, "
            "coordination-of-eroded to erode and remove, "
            "volumetric-strain to what "
            "strains the cell."
        )),
        other("stage", "only", "{ KEY = [values] }", "Runs the stage for these values of a swept key only."),
    };
}

std::vector<Key> servo_rows(const std::string& table) {
    return {
        detail::table(table, "servo", "What turns a stress error into a strain rate."),
        choice(
            table + ".servo", "kind", names::words_of(names::servo_kind),
            "secant: rate = error / (modulus x response time), does not ring; inertial: the reference's, rate += error "
            "x dt / mass."
        ),
        quantity(table + ".servo", "mass", dimension::mass_per_length, from_zero, "Inertial servo: its mass."),
        ratio(table + ".servo", "damping", {0, 1, false, true}, "Inertial servo: damping of its growth."),
        quantity(
            table + ".servo", "max_rate", dimension::rate, above_zero,
            "Largest strain rate of an axis under stress control. By default inertial number 1.7e-3 under the stress "
            "to bear (50 1/s for a sand of 0.21 mm at 100 kPa), at least twice the rate of strained axes."
        ),
        ratio(table + ".servo", "response", above_zero, "Secant servo: response time in steps."),
    };
}

Key shear_stresses(const char* where) {
    Key key = choice(
        where, "shear_stresses", names::words_of(names::shear_stresses),
        "kept: the cell keeps its angles, and shear stresses between the axes remain as they are; released: the cell "
        "shears until there are none, while the stresses are held. Needs the secant servo; later stages keep the "
        "sheared cell."
    );
    key.default_text = "\"kept\""; // not written, see shear_stresses_field
    return key;
}

std::vector<Key> movement_rows() {
    const std::string_view axes = "three texts, \"-\" where the other key gives the axis";
    Key stress = quantity(
        "stage.advance", "stress", dimension::pressure, from_zero,
        "Stress to hold along each axis, compression positive; exactly one of `stress` and `strain_rate` per axis."
    );
    stress.form = axes;
    Key rate = quantity(
        "stage.advance", "strain_rate", dimension::rate, any,
        "Strain rate along each axis, compression positive; exactly one of `stress` and `strain_rate` per axis."
    );
    rate.form = axes;
    Key settle_stress = quantity(
        "stage.settle", "stress", dimension::pressure, from_zero,
        "Stress to hold along each axis, compression positive; \"-\" keeps the axis at its length."
    );
    settle_stress.form = "three texts, \"-\" for an axis of fixed length";
    Key gradient = quantity(
        "stage.advance", "velocity_gradient", dimension::rate, any,
        "Velocity gradient dv/dx of the cell as three rows, extension positive; instead of the other two."
    );
    gradient.form = "three rows of three rates";
    Key imported_gradient = quantity(
        "stage.import", "velocity_gradient", dimension::rate, any,
        "Velocity gradient dv/dx of the cell that the velocities of the file contain, extension positive; the one that "
        "fits them best unless given."
    );
    imported_gradient.form = gradient.form;
    std::vector<Key> rows = {
        imported_gradient,
        required(count("stage.advance", "steps", count_from_zero, "Number of steps.")),
        time_step("stage.advance"),
        rate,
        stress,
        gradient,
    };
    append(rows, servo_rows("stage.advance"));
    append(
        rows,
        {
            settle_stress,
            quantity(
                "stage.settle", "pressure", dimension::pressure, from_zero,
                "The same stress to hold along all axes. Without `pressure` and `stress` the volume is held."
            ),
            shear_stresses("stage.settle"),
            time_step("stage.settle"),
            count("stage.settle", "max_steps", from_one, "Steps after which a stage that has not settled is an error."),
        }
    );
    append(rows, servo_rows("stage.settle"));
    return rows;
}

} // namespace

std::vector<Key> preparation_rows() {
    std::vector<Key> rows = common_rows();
    append(
        rows,
        {
            required(text(
                "stage.import", "packing",
                "File of grains: CSV, a table of Yade, PFC, EDEM or MFIX, LAMMPS data or dump, XYZ, VTK, MercuryDPM, "
                "Kratos; docs/packings.md lists what is understood."
            )),
            text(
                "stage.import", "contacts",
                "File of what the contacts of the packing remember, shear forces and moments: our own table or a "
                "LAMMPS "
                "dump of `pair_style granular`; docs/packings.md has the commands. Without it they remember nothing."
            ),
            other(
                "stage.import", "cell", "three lengths, or a 3 x 3 matrix whose columns are the cell vectors",
                "The periodic cell; needed unless the file carries it, as LAMMPS, extended XYZ and .vtp of `suffuse "
                "export` do."
            ),
            quantity(
                "stage.import", "unit", dimension::length, above_zero,
                "What a length of 1 in the file stands for, its velocities likewise: \"1 mm\" where it is in mm. Units "
                "in the "
                "headings of a table come first."
            ),
            quantity(
                "stage.import", "radius", dimension::length, above_zero,
                "Radius of all grains, for a file that has none."
            ),
            ratio(
                "stage.import", "max_overlap", {0, 2, true, false},
                "Largest overlap that is accepted / radius of the smaller grain."
            ),
            ratio(
                "stage.pack", "porosity", {0.45, 1, false, true},
                "Porosity of the cloud without overlaps; 0.5 for `layers` unless given."
            ),
            other(
                "stage.pack", "layers", "[{ soil = \"base\", thickness = \"3 mm\" }, ...]",
                "Soils one after the other in the order of the flow, the base first, periodic on all sides. The study "
                "then has neither `soil` nor `particles`: grains are as many as `width` and thicknesses hold. The "
                "grains of the first layer are fine: `migrate` moves them, and holds the others."
            ),
            choice(
                "stage.pack", "axis", names::words_of(names::axis),
                "With `layers`: across the layers; the flow goes along it."
            ),
            quantity(
                "stage.pack", "width", dimension::length, above_zero,
                "With `layers`: of their square cross-section, settled; at least three of the largest grains."
            ),
            required(text("stage.pack.layers", "soil", "Name of a [soil.NAME].")),
            required(quantity(
                "stage.pack.layers", "thickness", dimension::length, above_zero,
                "Along the axis, settled at a porosity of 0.4; at least three of the largest grains."
            )),
            required(quantity(
                "stage.compact", "pressure", dimension::pressure, above_zero, "Isotropic stress to reach and settle at."
            )),
            shear_stresses("stage.compact"),
            choice(
                "stage.compact", "protocol", names::words_of(names::protocol),
                "faithful: the reference's fabric in fewer steps; swift: the quickest, best with `void_ratio`, more "
                "contacts at the same void ratio; slow: the reference's own rates, time step and servo; wide: coarse "
                "grains six and more times the size of the fine ones, in a tenth of the steps of faithful."
            ),
            ratio(
                "stage.compact", "start_porosity", {0.2, 1, false, true},
                "Protocol swift: porosity to which the cloud is brought, without forces, before the first step; by "
                "default as low as overlaps clear easily."
            ),
            table("stage.compact", "prepare", "How contacts behave during compaction only."),
            quantity(
                "stage.compact.prepare", "friction", dimension::angle, friction_angle,
                "Lowered contact friction: a dense sample. For a void ratio all but swift search it, and ignore the "
                "one given."
            ),
            table(
                "stage.compact.prepare", "adhesion",
                "Adhesion of the contacts that are made during compaction, removed at its end: a loose sample."
            ),
            quantity(
                "stage.compact.prepare.adhesion", "normal", dimension::pressure, from_zero,
                "Pull-off force = this x min(r1, r2)^2."
            ),
            quantity(
                "stage.compact.prepare.adhesion", "shear", dimension::pressure, from_zero,
                "Shear strength without normal force = this x min(r1, r2)^2."
            ),
            flag(
                "stage.compact.prepare", "skeleton_first",
                "Coarse grains are compacted alone, in the way that `prepare` says; fines are then put into their "
                "voids, and all settle. Where they do not fit, the skeleton is widened, and all are compacted together."
            ),
            ratio(
                "stage.compact", "void_ratio", {0.1, 5, false, false},
                "Void ratio to meet: swift searches the porosity at its start, the others the friction during "
                "compaction."
            ),
            ratio(
                "stage.compact", "intergranular_void_ratio", {0.1, 50, false, false},
                "Instead: the void ratio with all fines counted as voids, e_g. The void ratio to meet follows from it "
                "and from the sample's fines content FC: e = e_g (1 - FC) - FC."
            ),
            ratio("stage.compact", "void_ratio_tolerance", above_zero, "How closely the void ratio is met."),
            choice(
                "stage.compact", "if_unreachable", names::words_of(names::if_unreachable),
                "error: a void ratio that is not met fails the sample; nearest: the preparation that comes nearest is "
                "taken, with a warning."
            ),
            table(
                "stage.compact", "prepared_as",
                "Samples of more fines than this take the friction and adhesion that the search found for the sample "
                "of "
                "so many, of the same seed and of all other swept keys; the others search."
            ),
            required(ratio(
                "stage.compact.prepared_as", "fines_content", share,
                "Of the sample to prepare by: a value of the sweep over `fines_content`."
            )),
            quantity(
                "stage.compact", "max_rate", dimension::rate, above_zero,
                "Largest strain rate while the cloud carries no load; not for swift. By default the one of inertial "
                "number 8.5e-3, with the pressure and the median diameter: 250 1/s for a sand of 0.21 mm at 100 kPa."
            ),
            time_step("stage.compact"),
        }
    );
    append(rows, movement_rows());
    return rows;
}

} // namespace suffuse::casefile::detail
