#include "suffuse/figures/figure_guide.hpp"

#include "suffuse/figures/figure_options.hpp"

#include <fmt/format.h>

#include <array>

namespace suffuse::figures {
namespace {

struct Guide {
    std::string_view id, title, shows, needs;
};

constexpr std::array guides = {
    Guide{
        "fig01", "gradings of the mixtures",
        "Percent passing by mass against size for the fines contents of a sweep, as specified and as drawn.",
        "a study whose soil has `coarse` and `fines`, swept over fines_content"},
    Guide{
        "fig02", "drained triaxial tests of a sweep",
        "Deviator stress q and volumetric strain against axial strain; compression positive, contraction positive. "
        "[report.overlay] lays measured points over it.",
        "`triaxial` stages in a study swept over fines_content"},
    Guide{
        "fig03", "void ratios against fines content",
        "Void ratio of the loose and the densest state (e, e_min), intergranular and equivalent void ratio (e_g, e_eq: "
        "all, or only inactive, fines counted as voids). The lowest e marks the threshold fines content.",
        "`compact` stages, loose and dense, in a study swept over fines_content"},
    Guide{
        "fig04", "share of active fines",
        "b: volume of the fines with at least two contacts over that of all fines, against fines content.",
        "`compact` stages in a study swept over fines_content"},
    Guide{
        "fig05", "contacts by class",
        "Shares of contacts between two coarse grains (LL), coarse and fine (LS), two fines (SS), against fines "
        "content.",
        "`compact` stages in a study swept over fines_content"},
    Guide{
        "fig06", "coarse-fine contacts among the strong ones",
        "Share of LS among contacts whose force exceeds the mean over all contacts, against fines content.",
        "`compact` stages in a study swept over fines_content"},
    Guide{
        "fig07", "the erosion loop", "The steps of a pass, with this run's counts of grains on the arrows.",
        "an `erode` stage"},
    Guide{
        "fig08", "grading of the sample", "The specified grading and that of the drawn grains; the fines are shaded.",
        "a `pack` stage"},
    Guide{
        "fig09", "speed of the fines by gradient",
        "Speed of the fines while the water's force grows and then stays, a panel a gradient: bands hold the middle 80 "
        "% of the grains that the rule calls detachable and of those that stay, lines are single grains, the fastest "
        "and slowest among them. One group keeps accelerating, the other deforms with its contacts.",
        "a `detach` stage"},
    Guide{
        "fig10", "speed of the fines by pass", "Like Figure 9, one panel for each pass of the erosion.",
        "an `erode` stage"},
    Guide{
        "fig11", "eroded mass by pass", "Mass that left in each pass, as a share of the mass before it.",
        "an `erode` stage"},
    Guide{
        "fig12", "contacts of the eroded grains",
        "How many contacts the grains had that left, by pass: fewer than two is inactive.", "an `erode` stage"},
    Guide{
        "fig13", "stress and volumetric strain over the erosions",
        "Mean stress relative to that before, and volumetric strain: at constant volume after each removal, then under "
        "the stresses held.",
        "an `erode` stage"},
    Guide{
        "fig14", "porosity over the erosions",
        "Porosity against eroded mass: up with each removal, down where the skeleton resettles.", "an `erode` stage"},
    Guide{
        "own-rules", "the two detachment rules against each other",
        "How many fines the velocity rule and the displacement rule call detachable, and how often they agree.",
        "a `detach` or `erode` stage"},
    Guide{
        "own-twin", "each fine grain against its twin",
        "Speed at the end of the probe with water against that of the same grain without, a panel a pass. On the "
        "diagonal the residual unbalanced forces move a grain, above it the water does.",
        "an `erode` stage"},
    Guide{
        "own-constrictions", "constrictions and fines",
        "Sizes of the constrictions of the coarse skeleton and of the fines: shows which fines could pass.",
        "an `erode` stage"},
    Guide{
        "own-transport", "travel of the detached fines",
        "Share of the mass detached in a pass that gets farther than a length along the flow before a constriction "
        "holds it.",
        "an `erode` stage whose `passes_constriction` has size = \"flow-path\""},
    Guide{
        "own-eroded-grading", "gradings before, of what left, and after", "By mass, against size.", "an `erode` stage"},
    Guide{
        "own-permeability", "permeability by pass", "Along the direction of the flow, before and after each pass.",
        "an `erode` stage"},
    Guide{
        "own-surrogate", "a soil and its surrogate",
        "The grading curve, where it is split, and the two fractions that stand for it.",
        "a soil with `surrogate`, [gravity], and a `detach` stage"},
    Guide{
        "own-mobility", "fines that a gradient moves",
        "Share of the fines' mass that a rising gradient moves against its weight; vertical lines: the specified "
        "gradient, Skempton and Brogan's α i_c with the α of the sample, and heave.",
        "[gravity], and a `detach` or `erode` stage"},
    Guide{
        "own-mobile-sizes", "which sizes move", "Mass of each size of the fines that moves, at some gradients.",
        "[gravity], and a `detach` or `erode` stage"},
    Guide{
        "own-calibration-intervals", "intervals in their ranges",
        "90 % interval of each parameter in the range that the case gives it, and the likeliest value.",
        "a calibration"},
    Guide{
        "own-calibration-fit", "fit of the tests",
        "Curves of the laboratory, the model at the likeliest parameters, and the band of its error.", "a calibration"},
    Guide{
        "own-calibration-held-out", "tests that were held out",
        "Curves that were not fitted, with the mean and the band of samples of the posterior.",
        "a calibration with targets that are `held_out`"},
    Guide{
        "own-calibration-corner", "posterior of each pair of parameters",
        "Equally likely sets of parameters, each pair of parameters a panel; how often each value occurs.",
        "a calibration of two parameters or more"},
    Guide{
        "own-calibration-misfits", "misfits of the samples",
        "How far each sample is from its test, over each parameter.", "a calibration"},
    Guide{
        "own-migration", "fines that leave as the gradient rises",
        "Mass that has crossed the exit, and permeability, at the end of each gradient.", "a `migrate` stage"},
    Guide{
        "own-migration-time", "fines that leave over time",
        "The same over the soil's own time, a point a solution of the flow.", "a `migrate` stage"},
    Guide{
        "own-filter-profile", "where the base is in its filter",
        "Solid of the filter, and of the base before and at the end, over the depth behind the interface.",
        "a `migrate` stage of `layers`"},
    Guide{
        "own-filter-cut", "a cut through base and filter",
        "Circles in which a plane along the flow cuts the grains, before and at the end.",
        "a `migrate` stage of `layers`"},
    Guide{
        "own-filter-sizes", "which sizes of the base pass",
        "Share of each size of the base beyond the interface, and of what left the filter.",
        "a `migrate` stage of `layers`"},
    Guide{
        "own-migration-power", "erosion rate against the power of the flow",
        "Mass that leaves in a second, over the power that the flow spends, a point a gradient; a line where the "
        "points carry one.",
        "a `migrate` stage in which fines left"},
    Guide{
        "own-migration-profile", "porosity, fines and permeability along the flow",
        "In slices across the flow, before and at the end of gradients.", "a `migrate` stage without layers"},
    Guide{
        "own-throat-flux", "flux through a throat against its size",
        "Median and middle 80 % of the flux, over its mean, of throats of one size: before and after erosion, or of "
        "flow stages.",
        "an `erode` or a `flow` stage"},
    Guide{
        "own-flux-shares", "how few throats carry the flow",
        "Which share of the flow goes through which share of the throats, those with most flux first, and the "
        "distribution of the fluxes.",
        "an `erode` or a `flow` stage"},
    Guide{
        "own-strength", "strength before and after", "The same test before fines went and after, laid over each other.",
        "a test before an erosion and the same after"},
    Guide{
        "own-sweep", "result of a study over the swept key",
        "Mean of the samples, a band of one standard deviation, and every sample as a dot.", "a study with a `sweep`"},
    Guide{
        "own-sweep-multiples", "the other results of a study over the swept key",
        "Like own-sweep, with a small panel for each result.", "a study with a `sweep`"},
    Guide{
        "own-triaxial", "triaxial tests before and after erosion",
        "Deviator stress and volumetric strain against axial strain.", "`triaxial` stages"},
    Guide{
        "own-paths", "paths of stress and of state",
        "Deviator stress against mean stress, unless all tests move along one line there, and void ratio against the "
        "logarithm of the mean stress.",
        "`triaxial` stages"},
    Guide{
        "own-pore-pressure", "rise of the pore pressure at constant deviator stress",
        "Excess pore pressure and axial strain of samples that hold their deviator stress while the pressure rises.",
        "`triaxial` stages with `path = \"constant-deviator\"`"},
    Guide{
        "own-compression", "compression and swelling",
        "Void ratio against the logarithm of the axial stress, loaded and unloaded.",
        "`oedometer` and `isotropic` stages"},
    Guide{
        "own-shear", "simple shear",
        "Ratio of shear to normal stress, normal stress and void ratio against shear strain.", "`shear` stages"},
    Guide{
        "own-cyclic", "cyclic loading",
        "Path of effective stress, loops of stress and strain, and the pore-pressure ratio against cycles.",
        "`cyclic` stages"},
    Guide{
        "own-cyclic-resistance", "cyclic resistance",
        "Amplitude of the cyclic stress ratio against the cycles to liquefaction, a color a state.",
        "two `cyclic` stages and more that liquefy"},
    Guide{
        "own-stiffness", "small-strain stiffness",
        "Shear modulus against the mean stress, with the bound of grains that all move with the mean strain.",
        "`stiffness` stages"},
    Guide{
        "own-stiffness-strain", "stiffness against strain",
        "Secant shear modulus against the logarithm of the shear strain, of small strains and of tests.",
        "`stiffness` stages, and tests that load without a turn"},
    Guide{
        "own-energy", "where the work of the tests goes",
        "Shares of the work that sliding and rolling contacts and damping take and that springs hold, a bar a test.",
        "`triaxial` stages"},
    Guide{
        "own-stress-probes", "stability against small loads in all directions",
        "Second-order work of loads of one size in all directions of axial against lateral stress, and the strains "
        "that they lead to: where the work is not above zero the sample can fail without more load.",
        "a `stress-probe` stage"},
    Guide{
        "own-stability-grading", "the grading and the criteria's sizes",
        "The grading with its gap, the split into fines and the sizes at which criteria look.",
        "a soil; also `suffuse assess`"},
    Guide{
        "own-stability-shape", "the shape curve",
        "Kenney and Lau's H = F(4d) - F(d) against F, with the limits H = F and H = 1.3 F.",
        "a soil; also `suffuse assess`"},
    Guide{
        "own-stability-overlay", "gradings of many samples",
        "The curves of all samples that `suffuse assess` was given, over each other.",
        "`suffuse assess` of several soils"},
    Guide{
        "own-stability-filter", "a soil and its filter",
        "The curves of both, under the verdict of the rules for filters.", "`suffuse assess --filter`"},
};

} // namespace

std::optional<std::string> explain_figure(std::string_view name) {
    const std::string id = figure_id(std::string(name));
    for (const Guide& guide : guides) {
        if (id == guide.id || id.starts_with(fmt::format("{}-", guide.id))) { // "own-paths-STUDY" is one of its kind
            const std::optional<int> number = figure_of_paper(id);
            const std::string title = number ? fmt::format("Figure {} of the paper: {}", *number, guide.title)
                                             : fmt::format("{}: {}", id, guide.title);
            return fmt::format(
                "{}\n  {}\n  drawn from  {}\n  files       figures/{}.csv, its numbers; suffuse figures RUN --figure "
                "{} "
                "--format svg|png|pdf\n",
                title, guide.shows, guide.needs, id, number ? std::to_string(*number) : id
            );
        }
    }
    return std::nullopt;
}

std::vector<std::string> figure_names() {
    std::vector<std::string> names;
    for (const Guide& guide : guides) {
        const std::optional<int> number = figure_of_paper(guide.id);
        names.push_back(number ? fmt::format("figure-{}", *number) : std::string(guide.id));
    }
    return names;
}

} // namespace suffuse::figures
