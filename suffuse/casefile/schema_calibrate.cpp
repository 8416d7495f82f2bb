// Rows of the schema: [calibrate].

#include "suffuse/casefile/schema_row.hpp"

namespace suffuse::casefile::detail {

std::vector<Key> calibrate_rows() {
    return {
        required(text("calibrate", "soil", "Name of the [soil.NAME] that the laboratory tested.")),
        count("calibrate", "particles", {100, 2e9, false, false}, "Grains of each sample."),
        count(
            "calibrate", "samples", {8, 10'000, false, false},
            "Samples of each target, at most: half of them over all of the ranges, the others where the curves agree."
        ),
        flag(
            "calibrate", "fix_void_ratio",
            "Whether samples have the `void_ratio` of their target. Otherwise the void ratio of the model is an "
            "unknown "
            "of each target: spheres are as dense as a sand at another void ratio."
        ),
        required(list_of(table(
            "calibrate", "targets", "Tests of the laboratory: { file = \"drained.csv\", pressure = \"100 kPa\" }."
        ))),
        required(other(
            "calibrate", "unknowns", "{ KEY = [LEAST, MOST] }",
            "Keys that are sought, as in `sweep`, with their ranges: { \"contact.friction\" = [\"20 deg\", \"40 "
            "deg\"], "
            "\"contact.modulus\" = [\"50 MPa\", \"2 GPa\", \"log\"], void_ratio = [0.55, 0.8] }."
        )),
        list_of(text(
            "calibrate", "constraints",
            "Comparisons of unknowns in SI, as in \"contact.rolling_friction <= 0.5 * contact.friction\"."
        )),
        text("calibrate.targets", "name", "Of its samples and its void ratio; else from `sample` or `file`."),
        required(text("calibrate.targets", "file", "Record of the test, as `suffuse import --kind triaxial` reads it.")
        ),
        choice(
            "calibrate.targets", "test", {"drained", "undrained", "oedometer"},
            "How it was done: triaxial compression, or an oedometer."
        ),
        text("calibrate.targets", "sample", "Which test of the file, where it has several."),
        choice(
            "calibrate.targets", "contraction", {"positive", "negative"},
            "Sign of volumetric strains in the file, where its numbers do not show it."
        ),
        required(quantity(
            "calibrate.targets", "pressure", dimension::pressure, above_zero,
            "Effective pressure on all sides at the start of the test; of an oedometer, where its curve begins."
        )),
        ratio("calibrate.targets", "void_ratio", above_zero, "Of the model, with `fix_void_ratio`."),
        text(
            "calibrate.targets", "void_ratio_of",
            "Another target, of the same density: their samples share one unknown void ratio."
        ),
        ratio("calibrate.targets", "void_ratio_tolerance", above_zero, "That samples may miss their void ratio by."),
        ratio("calibrate.targets", "strain", {0, 0.5, true, false}, "Axial strain up to which curves are compared."),
        ratio(
            "calibrate.targets", "scatter", above_zero,
            "Scatter expected of the measurement, as a share of the largest value of its curve."
        ),
        ratio("calibrate.targets", "weight", above_zero, "Of this target among the others."),
        flag("calibrate.targets", "held_out", "Whether the test is predicted by what the others give, and not fitted."),
    };
}

} // namespace suffuse::casefile::detail
