"""G0 against pressure and void ratio: the table of docs/theory/stiffness.md. Takes two minutes.

Each sample is loaded step by step by `isotropic`, and probed by `stiffness` at each pressure."""

import json
import pathlib
import sys

import numpy as np
import suffuse

PRESSURES = [50e3, 100e3, 200e3, 400e3, 800e3]  # [Pa]
LAWS = {
    "linear": {"modulus": 356e6},
    "hertz-mindlin": {"law": "hertz-mindlin", "modulus": 20e9, "poisson": 0.2},
}


def hardin(e):
    """How stiffness depends on the void ratio in sands with round grains [HardinRichart1963]."""
    return (2.17 - e) ** 2 / (1 + e)


def sample(law, void_ratio, seed):
    radii = np.random.default_rng(seed).uniform(0.05e-3, 0.1e-3, 1000)  # [m]
    sand = suffuse.make_cloud(radii, seed=seed)
    for name, value in LAWS[law].items():
        setattr(sand.material, name, value)
    sand.material.friction = np.radians(30)
    sand.compact(PRESSURES[0], void_ratio=void_ratio, protocol="swift", void_ratio_tolerance=0.005)
    return sand


def measure(law, void_ratio, seed):
    sand, rows = sample(law, void_ratio, seed), []
    for pressure in PRESSURES:
        if pressure > PRESSURES[0]:
            sand.isotropic([pressure])
        found = sand.stiffness()
        rows.append({"law": law, "seed": seed, "pressure": pressure, "void_ratio": sand.void_ratio,
                     **{key: found[key] for key in ("shear_modulus", "mean_field_shear", "poisson_ratio",
                                                    "anisotropy", "nonlinearity", "reciprocity")}})
    return rows


def exponent(rows):
    """n of G = A F(e) p^n, by least squares over the rows of one sample."""
    p = np.log([row["pressure"] for row in rows])
    g = np.log([row["shear_modulus"] / hardin(row["void_ratio"]) for row in rows])
    return np.polyfit(p, g, 1)[0]


def main():
    every = []
    for law in LAWS:
        for void_ratio in (0.62, 0.70, 0.78):
            samples = [measure(law, void_ratio, seed) for seed in (5, 6, 7)]
            exponents = [exponent(rows) for rows in samples]
            every += [row for rows in samples for row in rows]
            moduli = [np.mean([rows[k]["shear_modulus"] for rows in samples]) / 1e6 for k in range(len(PRESSURES))]
            bound = np.mean([rows[1]["shear_modulus"] / rows[1]["mean_field_shear"] for rows in samples])
            print(f"{law:14} e {void_ratio}  G0 " + " ".join(f"{g:6.1f}" for g in moduli)
                  + f" MPa  n {np.mean(exponents):.3f} +- {np.std(exponents, ddof=1):.3f}  over the bound {bound:.2f}"
                  f"  nonlinear {max(row['nonlinearity'] for rows in samples for row in rows):.1e}", flush=True)
    if len(sys.argv) > 1:
        pathlib.Path(sys.argv[1]).write_text(json.dumps(every, indent=1))


main()
