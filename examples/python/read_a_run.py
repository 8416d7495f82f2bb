#!/usr/bin/python3
"""Read a run and draw a custom figure: how density and stress went through its stages.

    read_a_run.py [FOLDER OF A RUN [OUTPUT]]

Without a folder, the replay example is run first, into runs/, which takes a second. With matplotlib a PNG is drawn, else the
numbers are written as CSV.
"""

import pathlib
import sys

import numpy

import suffuse

if len(sys.argv) > 1:
    run = suffuse.Run(sys.argv[1])
else:
    case = suffuse.Case(pathlib.Path(__file__).parents[1] / "replay" / "case.toml")
    print(case.plan())
    run = case.run(on_progress=suffuse.print_progress)
output = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "read_a_run.png")

for name in run:
    stage = run[name]
    print(f"{name:30} {stage['verb']:9} {stage['grains']:6} grains  void ratio {stage['void_ratio']:.4f}  "
          f"mean stress {stage['mean_stress'] / 1e3:6.1f} kPa")
    for index, passed in enumerate(stage.passes, 1):
        of = f" of {passed['detachable']} that the water detached" if "detachable" in passed else ""
        print(f"{'':30} pass {index}: {passed['removed']} grains left{of}")
print(f"{len(run.figures)} figures: {', '.join(run.figures) or 'none'}; report {run.report}")

histories = {name: run[name].history for name in run if len(run[name].history) > 1}
try:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    output = output.with_suffix(".csv")
    with open(output, "w", encoding="utf-8") as file:
        print("stage,step,void_ratio,mean_stress", file=file)
        for name, rows in histories.items():
            for row in rows:
                mean = (row["stress_1"] + row["stress_2"] + row["stress_3"]) / 3
                print(name, int(row["step"]), row["void_ratio"], mean, sep=",", file=file)
else:
    figure, (upper, lower) = pyplot.subplots(2, 1, sharex=True, figsize=(6, 5), layout="constrained")
    for name, rows in histories.items():
        mean = numpy.mean([rows[f"stress_{axis}"] for axis in (1, 2, 3)], axis=0)
        upper.plot(rows["step"], rows["void_ratio"], label=name)
        lower.plot(rows["step"], mean / 1e3)
    upper.set_ylabel("void ratio e [-]")
    lower.set_ylabel("mean stress p [kPa]")
    lower.set_xlabel("step")
    upper.legend(frameon=False)
    figure.savefig(output, dpi=120)
print(f"drawn: {output}")
