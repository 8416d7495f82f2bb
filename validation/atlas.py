#!/usr/bin/python3
"""The atlas of gradients that move fines: atlas.toml for each size ratio, fines content and seed, with three densities.

A row is one sample under one flow. They lie in suffuse/atlas/gradients.csv, which is built into the program. Rows that are
there are not computed again, so that it can be made in portions: ./run validation/atlas.py --ratio 6.5 --density ends
--seeds 1. Without words it makes all. It ends with a map of what is there; --draw makes the map alone."""

import math
import sys

import common

RATIOS = [3.5, 4.5, 6.5, 10]
CONTENTS = [5, 10, 15, 20, 25, 30, 35]  # [%]
SEEDS = [1, 2, 3]
DENSITIES = {"ends": ["loose", "dense"], "between": ["medium"]}
HOME = common.ROOT / "suffuse" / "atlas" / "gradients.csv"
NAN = math.nan


def number(value):
    return NAN if value is None else value


def row_of(stage):
    """What one ramp of gradients found. A gradient with its mark is at most so high: the motion had not ended."""
    gradients, at_most = stage["critical_gradient"], stage["critical_gradient_at_most"]
    return {
        "grains": stage["grains"],
        "porosity": stage["porosity"],
        "alpha": stage["alpha_fines"],
        "i_c": number(stage["heave_gradient"]),
        "i1": number(gradients["1 %"]), "i1_at_most": int(at_most["1 %"]),
        "i10": number(gradients["10 %"]), "i10_at_most": int(at_most["10 %"]),
        "i50": number(gradients["50 %"]), "i50_at_most": int(at_most["50 %"]),
        "drag_share": stage["fines_drag_share"],
        "load_bearing": stage["load_bearing_mass_share"],
        "sifting": stage["sifting_mass_share"],
    }


def changes_of(study, ratio, content, seed):
    soil = f"ratio-{ratio:g}".replace(".", "-")
    return {"seed": seed, f"study.{study}.sweep": {"soil": [soil], "fines_content": [f"{content} %"]}}


def make(given, samples, study, ratio, content, seed):
    """Adds the rows of one sample, where they are not there yet."""
    key = {"ratio": float(ratio), "fines": content / 100, "seed": float(seed)}
    rows = {density: samples.of(**key, density=density) for density in ("loose", "dense", "medium")}
    if all(rows[density] for density in DENSITIES[study]):
        return
    changes = changes_of(study, ratio, content, seed)
    if study == "between":
        if not (rows["loose"] and rows["dense"]):
            return  # of the ends, which come first
        porosity = {density: rows[density][0]["porosity"] for density in ("loose", "dense")}
        void_ratio = sum(n / (1 - n) for n in porosity.values()) / 2
        changes["study.between.stage.medium.void_ratio"] = round(void_ratio, 4)
    run = common.conduct(given, "atlas", [study], changes, folder=f"atlas/{study}-{ratio:g}-{content}-{seed}")
    for name in sorted(run.stages):
        density, _, flow = name.split("/")[-1].partition("-")
        if flow:
            samples.add(**key, density=density, flow=flow, **row_of(run[name]))
            print(name, f"seed {seed}", *(f"{k} {v:.3g}" for k, v in row_of(run[name]).items()), file=sys.stderr, flush=True)


def nodes_of(samples):
    """What upward flow needs to move 1 % of the fines, over i_c: the mean over the seeds of each place on the map."""
    places = {}
    for row in samples.of(flow="up"):
        places.setdefault((row["ratio"], row["fines"], row["density"]), []).append(row["i1"] / row["i_c"])
    return [
        {"size ratio": ratio, "fines": 100 * fines, "density": density, "i1/i_c": round(sum(found) / len(found), 3)}
        for (ratio, fines, density), found in sorted(places.items())
        if not any(map(math.isnan, found))
    ]


def draw_map(given, samples):
    axes = {
        "x": {"field": "fines", "type": "ordinal", "title": "fines content [%]", "axis": {"labelAngle": 0}},
        "y": {"field": "size ratio", "type": "ordinal", "title": "size ratio D50/d50 [-]", "sort": "descending"},
    }
    color = {"field": "i1/i_c", "type": "quantitative", "scale": {"scheme": "viridis", "domain": [0, 1]}, "title": "i1/i_c"}
    label = {"field": "i1/i_c", "type": "quantitative", "format": ".2f"}
    text_color = {"condition": {"test": "datum['i1/i_c'] > 0.6", "value": "black"}, "value": "white"}
    common.draw(given, "atlas", {
        "data": {"values": nodes_of(samples)},
        "facet": {"column": {"field": "density", "type": "nominal", "title": None, "sort": ["loose", "medium", "dense"]}},
        "spec": {"width": {"step": 46}, "height": {"step": 34}, "layer": [
            {"mark": "rect", "encoding": {**axes, "color": color}},
            {"mark": {"type": "text", "fontSize": 11}, "encoding": {**axes, "text": label, "color": text_color}},
        ]},
    })


def main():
    given = common.options(__doc__, {"ratio": RATIOS, "fines": CONTENTS, "density": list(DENSITIES)}, len(SEEDS))
    samples = common.Samples(given, "atlas", home=HOME)
    for study in [] if given.draw else given.density:
        for seed in SEEDS[:given.seeds]:
            for ratio in given.ratio:
                for content in given.fines:
                    make(given, samples, study, ratio, content, seed)
    draw_map(given, samples)


main()
