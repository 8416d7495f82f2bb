#!/usr/bin/python3
"""Soils that can be simulated whole, and their surrogates: surrogate.toml for each soil, density and seed.

Both parts of a soil are log-uniform. Rows that are in surrogate.csv are not computed again. Soils
no wider than a surrogate agree with it by construction, up to the scatter of samples."""

import math
import statistics
import sys

import common

# name: ratio D50/d50, widths of the coarse part and of the fines (largest over smallest), fines content [%], density
SOILS = {
    "d": (4.5, 3.0, 1.5, 20, "dense"),
    "f": (5.5, 2.5, 2.5, 25, "dense"),
    "h": (6.5, 2.5, 2.0, 20, "loose"),
    "i": (4.0, 4.0, 4.0, 25, "dense"),  # coarse and fines meet: no gap
    "j": (3.0, 3.0, 3.0, 20, "loose"),  # likewise
    "k": (4.5, 2.5, 6.0, 15, "loose"),
    "l": (5.0, 4.0, 3.0, 15, "dense"),
    "m": (4.0, 3.0, 16 / 3, 20, "loose"),  # no gap
    # as narrow as a surrogate can be, which is another sample of the soil itself: how much samples differ
    "a": (3.5, 2.0, 2.0, 20, "dense"),
    "b": (3.5, 1.5, 3.0, 30, "loose"),
    "c": (4.5, 2.0, 2.0, 10, "loose"),
    "e": (5.5, 2.0, 2.0, 15, "loose"),
    "g": (6.5, 1.5, 1.5, 10, "dense"),
}
WIDEST = (2.0, 4.0)  # coarse part and fines of a surrogate
SEEDS = [1, 2, 3]
FRICTION = {"dense": "10 deg", "loose": "37 deg"}  # while compacted; the grains have 37 deg
NAN = math.nan


def sizes_of(ratio, coarse_width, fines_width):
    """The four ends of the two parts [mm], the median of the coarse one at 1 mm."""
    half_coarse, half_fines = math.sqrt(coarse_width), math.sqrt(fines_width)
    return [1 / ratio / half_fines, 1 / ratio * half_fines, 1 / half_coarse, half_coarse]


def mm(sizes):
    return [f"{size:.6g} mm" for size in sizes]


def coarse_grains(width):
    """So many that the cell is three of the largest wide."""
    return round(105 * (width / 2) ** 2.5)


def changes_of(name, seed):
    ratio, coarse_width, fines_width, content, density = SOILS[name]
    sizes, share = sizes_of(ratio, coarse_width, fines_width), f"{content} %"
    changes = {
        "seed": seed,
        "soil.whole.coarse.psd": {"d": mm(sizes[2:]), "passing": ["0 %", "100 %"]},
        "soil.whole.fines.psd": {"d": mm(sizes[:2]), "passing": ["0 %", "100 %"]},
        "soil.whole.fines_content": share,
        "study.whole.sample_size.coarse_grains": max(105, coarse_grains(coarse_width)),
        "study.stand-in.sample_size.coarse_grains": max(60, coarse_grains(min(coarse_width, WIDEST[0]))),  # as suffuse new has it
    }
    if sizes[2] > 1.0001 * sizes[1]:
        changes["soil.stand-in.psd"] = {"d": mm(sizes), "passing": ["0 %", share, share, "100 %"]}
    else:
        changes["soil.stand-in.psd"] = {"d": mm([sizes[0], sizes[1], sizes[3]]), "passing": ["0 %", share, "100 %"]}
    changes["soil.stand-in.surrogate.finer_than"] = f"{math.sqrt(sizes[1] * sizes[2]):.6g} mm"
    for study in ("whole", "stand-in"):
        changes[f"study.{study}.stage.initial.prepare.friction"] = FRICTION[density]
    return changes


def row_of(stage):
    gradients = stage["critical_gradient"]
    return {
        "grains": stage["grains"],
        "porosity": stage["porosity"],
        "alpha": stage["alpha_fines"],
        "i_c": stage["heave_gradient"],
        "i1": NAN if gradients["1 %"] is None else gradients["1 %"],
        "i10": NAN if gradients["10 %"] is None else gradients["10 %"],
        "single": stage["single_grain_gradient"],
        "sifting": stage["sifting_mass_share"],
    }


def make(given, samples, name, seed):
    for model in ("whole", "stand-in"):
        if samples.of(soil=name, seed=float(seed), model=model):
            continue
        run = common.conduct(given, "surrogate", [model], changes_of(name, seed), folder=f"surrogate/{name}-{seed}-{model}")
        row = row_of(run[f"{model}/up"])
        samples.add(soil=name, seed=float(seed), model=model, **row)
        print(name, seed, model, *(f"{key} {value:.3g}" for key, value in row.items()), file=sys.stderr, flush=True)


def mean_of(rows, column):
    values = [row[column] for row in rows if math.isfinite(row[column])]
    return (statistics.fmean(values), statistics.stdev(values) if len(values) > 1 else 0.0) if values else (NAN, 0.0)


def text(pair):
    return "–" if math.isnan(pair[0]) else f"{pair[0]:.2f} ± {pair[1]:.2f}"


def is_wider(name):
    """Than its surrogate."""
    _, coarse_width, fines_width, _, _ = SOILS[name]
    return coarse_width > WIDEST[0] or fines_width > WIDEST[1]


def errors_of(samples, name):
    """Prints the soil's row. Relative errors of its surrogate's gradients, and of the estimate by single grains."""
    ratio, coarse_width, fines_width, content, density = SOILS[name]
    whole, model = (samples.of(soil=name, model=model) for model in ("whole", "stand-in"))
    pairs = {key: (mean_of(whole, key), mean_of(model, key)) for key in ("i1", "i10", "alpha")}
    single = 1.07 * mean_of(whole, "single")[0]
    print(
        f"{name:4} {ratio:5.1f} {coarse_width:.1f}, {fines_width:.1f}  {content:3} %  {density:7}",
        *(f"{text(a)}, {text(b)}" for a, b in pairs.values()), f"{single:.2f}", sep="  ",
    )
    of_model = {key: pairs[key][1][0] / pairs[key][0][0] - 1 for key in ("i1", "i10")}
    return {**of_model, "single": single / pairs["i1"][0][0] - 1}


def main():
    given = common.options(__doc__)
    samples = common.Samples(given, "surrogate")
    for seed in [1] if given.quick else SEEDS:
        for name in "g" if given.quick else SOILS:
            make(given, samples, name, seed)
    print("soil ratio widths   fines density  i1 whole, surrogate        i10 whole, surrogate       alpha whole, surrogate     1.07 x single")
    off = {name: errors_of(samples, name) for name in SOILS if samples.of(soil=name)}
    verdict = common.Verdict()
    for key, what in (("i1", "surrogates' i1"), ("i10", "surrogates' i10"), ("single", "1.07 x single-grain gradient, of i1")):
        for wider, which in ((True, "wider than their surrogates"), (False, "as narrow as they")):
            known = [errors[key] for name, errors in off.items() if is_wider(name) == wider and math.isfinite(errors[key])]
            if known:
                rms = math.sqrt(statistics.fmean(value**2 for value in known))
                print(f"{what}: bias {100 * statistics.fmean(known):+.0f} %, rms {100 * rms:.0f} % of {len(known)} soils {which}")
                verdict.at_most(f"{what}: rms", rms, 0.3)
    verdict.end()


main()
