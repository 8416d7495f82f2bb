// Rows of the schema: the tests of a laboratory, stress probes and stiffness.

#include "suffuse/casefile/names.hpp"
#include "suffuse/casefile/schema_row.hpp"

#include <fmt/format.h>

namespace suffuse::casefile::detail {

namespace {

/// How quickly a test loads, and how closely it is recorded.
std::vector<Key> pace_rows(const std::string& where, std::string_view own_inertia = "") {
    Key inertial = ratio(
        where, "inertial_number", above_zero,
        "Sets the axial strain rate, by the pressure at the start and the median diameter; no axis moves faster than "
        "twice that; \"strict\" is 1e-4, \"loose\" 1e-3."
    );
    inertial.form = "a ratio above 0, or \"strict\" (1e-4), or \"loose\" (1e-3)";
    return {
        inertial,
        choice(
            where, "inertia", names::words_of(names::grain_inertia),
            fmt::format(
                "Whether small grains and rotations are lent inertia during the test, for longer steps. A given "
                "`time_step`{} grains their own.",
                own_inertia.empty() ? " leaves" : own_inertia
            )
        ),
        time_step(where.c_str()),
        count(where, "rows", {1, 1e6, false, false}, "Stress-strain rows over the specified strain."),
    };
}

constexpr Range test_strain{0, 2, true, false};

Key driven_axis(const std::string& where) {
    return choice(where, "axis", names::words_of(names::axis), "The axis that is compressed.");
}

Key test_direction(const std::string& where) {
    return choice(where, "direction", names::words_of(names::direction), "Whether the axis is compressed or extended.");
}

std::vector<Key> triaxial_rows() {
    std::vector<Key> rows{
        choice(
            "stage.triaxial", "path", names::words_of(names::triaxial_path),
            "What is held: lateral stresses, mean stress, deviator stress while the cell widens as if pore pressure "
            "rose, volume, or the ratio of strains."
        ),
        driven_axis("stage.triaxial"),
        test_direction("stage.triaxial"),
        ratio(
            "stage.triaxial", "b", share,
            "True triaxial test, drained: (s2 - s3)/(s1 - s3) of the lateral axis after the driven one, in the order "
            "x, y, z, x; the other lateral stress is held."
        ),
        ratio(
            "stage.triaxial", "strain", test_strain,
            "Axial strain to stop at; at a constant deviator, where a sample first lengthens, also twice its widening."
        ),
        ratio(
            "stage.triaxial", "strain_ratio", any,
            "Path \"proportional\": volumetric over axial strain. 1: oedometer, 0: undrained, below 0: dilation."
        ),
        quantity(
            "stage.triaxial", "deviator_stress", dimension::pressure, above_zero,
            "Size of the deviator stress q to stop at and settle; the strain is then a limit."
        ),
        ratio(
            "stage.triaxial", "stress_ratio", {0, 3, true, true},
            "Size of the ratio q/p to stop at and settle; the strain is then a limit."
        ),
    };
    append(rows, pace_rows("stage.triaxial", " and the path \"constant-deviator\" leave"));
    return rows;
}

/// Of the verbs that go from stress to stress.
std::vector<Key> stresses_rows(const std::string& where, std::string_view what) {
    std::vector<Key> rows{
        choice(where, "axis", names::words_of(names::axis), "The axis that is compressed and extended."),
        required(list_of(quantity(where, "stresses", dimension::pressure, above_zero, what))),
        ratio(where, "strain", test_strain, "Axial strain beyond which a stress is out of reach."),
    };
    append(rows, pace_rows(where));
    return rows;
}

std::vector<Key> laboratory_rows() {
    std::vector<Key> rows = stresses_rows(
        "stage.oedometer",
        "Axial stresses to come to one after the other, without lateral strain; the sample settles at the last."
    );
    append(
        rows,
        stresses_rows(
            "stage.isotropic", "Stresses along all axes to come to one after the other; the sample settles at the last."
        )
    );
    append(
        rows, {driven_axis("stage.plane-strain"), test_direction("stage.plane-strain"),
               ratio(
                   "stage.plane-strain", "strain", test_strain,
                   "Axial strain to stop at. The lateral axis after the driven one, in the order x, y, z, x, keeps its "
                   "length; the stress along the other is held."
               )}
    );
    append(rows, pace_rows("stage.plane-strain"));
    append(
        rows,
        {choice(
             "stage.shear", "hold", names::words_of(names::shear_hold),
             "Simple shear at constant volume, or at constant stress along the normal of the planes that slide. The "
             "other sides of the cell keep their lengths."
         ),
         choice(
             "stage.shear", "axes", names::words_of(names::shear_axes),
             "The normal of the planes that slide, and the axis along which they do."
         ),
         ratio(
             "stage.shear", "strain", test_strain,
             "Shear strain to stop at: displacement of the top over the height at the start."
         )}
    );
    append(rows, pace_rows("stage.shear"));
    append(
        rows,
        {choice(
             "stage.cyclic", "drainage", names::words_of(names::drainage),
             "Whether the volume is held, or the lateral stresses."
         ),
         driven_axis("stage.cyclic"),
         ratio(
             "stage.cyclic", "csr", {0, 2, true, false},
             "Cyclic stress ratio: amplitude of the deviator stress over twice the mean stress at the start."
         ),
         ratio("stage.cyclic", "strain_amplitude", {0, 1, true, true}, "Instead: amplitude of the axial strain."),
         count("stage.cyclic", "cycles", {1, 1e5, false, false}, "The test ends after so many, or before by `until`."),
         table("stage.cyclic", "until", "What ends the test before."),
         ratio(
             "stage.cyclic.until", "pore_pressure_ratio", {0, 1, true, false},
             "Undrained: excess pore pressure over the lateral stress at the start."
         ),
         ratio(
             "stage.cyclic.until", "double_amplitude", {0, 2, true, false},
             "Axial strain from one turn of the load to the next."
         )}
    );
    append(rows, pace_rows("stage.cyclic"));
    return rows;
}

std::vector<Key> stress_probe_rows() {
    return {
        choice(
            "stage.stress-probe", "axis", names::words_of(names::axis),
            "The axis of symmetry: the two other stresses change alike."
        ),
        count(
            "stage.stress-probe", "directions", {4, 3600, false, false},
            "Loads, spaced equally over all directions of axial against lateral stress."
        ),
        ratio("stage.stress-probe", "increment", {0, 1, true, false}, "Size of each load / mean stress of the sample."),
        count("stage.stress-probe", "ramp", {50, 1e15, false, false}, "Steps in which a load grows to its size."),
        ratio(
            "stage.stress-probe", "unbalanced_force", above_zero,
            "The sample rests at this before the loads, and again under each."
        ),
        ratio(
            "stage.stress-probe", "max_strain", {0, 1, true, false},
            "Size of the strain beyond which the sample counts as failing under a load."
        ),
        count(
            "stage.stress-probe", "max_steps", from_one,
            "Steps under the whole load after which a sample that has not come to rest counts as creeping."
        ),
        time_step("stage.stress-probe"),
    };
}

std::vector<Key> stiffness_rows() {
    return {
        ratio(
            "stage.stiffness", "increment", {0, 0.01, true, true},
            "Size of each strain, axial or engineering shear. Half of it is put on first: the moduli by both show "
            "whether the strain is in the elastic range."
        ),
        ratio("stage.stiffness", "unbalanced_force", above_zero, "The sample rests at this before the strains."),
        count(
            "stage.stiffness", "max_steps", from_one,
            "Steps, at most, until the sample rests, and again until each strain has its stress."
        ),
        time_step("stage.stiffness"),
    };
}

} // namespace

std::vector<Key> test_rows() {
    std::vector<Key> rows = triaxial_rows();
    append(rows, laboratory_rows());
    append(rows, stress_probe_rows());
    append(rows, stiffness_rows());
    return rows;
}

} // namespace suffuse::casefile::detail
