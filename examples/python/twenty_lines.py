#!/usr/bin/python3
"""suffuse from Python in twenty lines: a case is changed, checked, priced and run, its results read, water sent through.

    twenty_lines.py [PARTICLES]
"""

import pathlib
import sys

import suffuse as w

EXAMPLES = pathlib.Path(__file__).parents[1]

case = w.Case.load(EXAMPLES / "fontainebleau-2016" / "case.toml", preset="quick")
case["study.erosion"].set(particles=int(sys.argv[1]) if len(sys.argv) > 1 else 1500, gradient=0.05)
case.check()                                   # raises CaseProblems with places
print(case.plan())                             # steps, time range, memory

run = case.run(until="erosion", threads=2, on_event=w.progress())
sample = run["erosion/initial"]                # a stage's state, numpy views, no copies
print(sample.porosity, sample.void_ratio, sample.stress("kPa"), sep="\n")
x, r = sample.grains.position, sample.grains.radius
strong = sample.contacts[sample.contacts.force_n > sample.contacts.force_n.mean()]
print(f"{len(strong)} strong contacts carry {strong.force_n.sum() / sample.contacts.force_n.sum():.2f} of the force")

net = w.PoreNetwork(sample)                    # pore network alone, also on imported packs
flow = net.solve(gradient=(0, 0, 0.05), viscosity="1 mPa*s")
print(flow.permeability, net.constrictions(of="coarse").mean)

for p in run["erosion/erosion"].passes:
    print(p.index, p.eroded_mass_percent, p.coordination_histogram)
print(run.figure(13).data.dtype.names)         # and run.figure(13).save("fig13.svg"), run.report.open()
print("whole" if not run.verify()["damages"] else "damaged", run.report)

pack = w.read(EXAMPLES / "replay" / "packing.csv", format="csv", cell=("1.436 mm", "1.436 mm", "1.436 mm"))
print(w.assess(pack.psd)["summary"])
