#!/usr/bin/python3
"""The atlas of filters: which share of a base passes, over D15/d85, the base's own width and the gradient.

A row is one sample of filter_atlas.toml at one gradient. They lie in suffuse/atlas/filters.csv, which is built into the
program. Rows that are there are not computed again, so that it can be made in portions: ./run validation/filter_atlas.py
--ratio 5 --width 1.15 --seeds 1. Without words it makes all. It ends with a table and a picture of what is there; --draw makes these alone."""

import sys

import common

RATIOS = [3, 4, 5, 6, 7, 9]  # D15 of the filter over d85 of the base
WIDTHS = [1.15, 2]  # d85/d15 of the base
SEEDS = [1, 2, 3]
LARGEST_OF_WIDE = 7  # a wide base of ratio 9 has 60,000 grains
HOME = common.ROOT / "suffuse" / "atlas" / "filters.csv"
FILTER_D15 = 0.9 * (1.1 / 0.9) ** 0.15  # [mm]


def base_of(ratio, width):
    """Its smallest and largest grain [mm]: a straight line over the logarithm of the size."""
    d85, factor = FILTER_D15 / ratio, width ** (1 / 0.70)
    return d85 / factor**0.85, d85 * factor**0.15


def rows_of(run):
    """What each gradient left, one after another."""
    stage, before = run["stack/flow"], run["stack/initial"]
    stack = stage["stack"]
    for hold in stage["holds"]:
        yield {
            "gradient": hold["gradient"],
            "grains": before["grains"],
            "thickness": stack["base_thickness"] / stack["filter_d15"],
            "constriction": stack["controlling_constriction"] / stack["filter_d15"],
            "passed": hold["eroded_mass_share"],
            "moving": hold["moving_mass_share"],
            "ended": int(hold["ended"]),
            "entered": hold["entered_mass_share"],
            "overlap": stage["largest_overlap"],
        }


def make(given, samples, ratio, width, seed):
    """Adds the rows of one sample, where they are not there yet."""
    key = {"ratio": float(ratio), "width": float(width), "seed": float(seed)}
    if samples.of(**key):
        return
    smallest, largest = base_of(ratio, width)
    sizes = {"d": [f"{smallest:.4g} mm", f"{largest:.4g} mm"], "passing": ["0 %", "100 %"]}
    run = common.conduct(
        given, "filter_atlas", changes={"seed": seed, "soil.base.psd": sizes}, folder=f"filter_atlas/{ratio:g}-{width:g}-{seed}"
    )
    for row in rows_of(run):
        samples.add(**key, **row)
        print(f"{ratio:g} {width:g} seed {seed}", *(f"{k} {v:.3g}" for k, v in row.items()), file=sys.stderr, flush=True)


def draw(given, samples):
    values = [
        {
            "D15/d85": row["ratio"], "passed": 100 * row["passed"], "base": f"d85/d15 = {row['width']:g}",
            "gradient": f"i = {row['gradient']:g}", "motion": "ended" if row["ended"] else "not ended: a lower bound",
        }
        for row in samples.rows
    ]
    common.draw(given, "filter_atlas", {
        "data": {"values": values},
        "facet": {"column": {"field": "gradient", "type": "nominal", "title": None}},
        "spec": {
            "width": 260, "height": 220, "mark": {"type": "point", "filled": False, "size": 60, "strokeWidth": 1.6},
            "encoding": {
                "x": {"field": "D15/d85", "type": "quantitative", "scale": {"domain": [2.5, 9.5]}, "title": "D15 of the filter over d85 of the base [-]"},
                "y": {"field": "passed", "type": "quantitative", "title": "passed [% of the base]"},
                "color": {"field": "base", "type": "nominal", "title": None},
                "shape": {"field": "motion", "type": "nominal", "title": None, "scale": {"domain": ["ended", "not ended: a lower bound"], "range": ["circle", "triangle-up"]}},
            },
        },
    })


def print_table(samples):
    print("| D15/d85 | d85/d15 of the base | samples | i | passed | still moving | motion ended | entered | constriction over D15 |")
    print("|---|---|---|---|---|---|---|---|---|")
    for width, ratio, gradient in sorted({(row["width"], row["ratio"], row["gradient"]) for row in samples.rows}):
        rows = samples.of(width=width, ratio=ratio, gradient=gradient)
        passed = ", ".join(f"{100 * row['passed']:.2g}" for row in rows)
        print(
            f"| {ratio:g} | {width:g} | {len(rows)} | {gradient:g} | {passed} % | {100 * common.mean(rows, 'moving'):.2g} % "
            f"| {sum(row['ended'] for row in rows):g} of {len(rows)} | {100 * common.mean(rows, 'entered'):.0f} % "
            f"| {min(row['constriction'] for row in rows):.2f} to {max(row['constriction'] for row in rows):.2f} |"
        )


def main():
    given = common.options(__doc__, {"ratio": RATIOS, "width": WIDTHS}, len(SEEDS))
    samples = common.Samples(given, "filters", home=HOME)
    for seed in [] if given.draw else SEEDS[:given.seeds]:
        for width in given.width:
            for ratio in given.ratio:
                if width == WIDTHS[0] or ratio <= LARGEST_OF_WIDE:
                    make(given, samples, ratio, width, seed)
    print_table(samples)
    draw(given, samples)


main()
