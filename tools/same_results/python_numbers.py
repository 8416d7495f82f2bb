"""Prints what the Python module computes from one small packing, as JSON: arrays by their bytes."""

import hashlib
import inspect
import json
import pathlib

import numpy
import suffuse

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
CELL = (1.4360856339985508e-3, 1.4358137235332051e-3, 1.436026846625529e-3)
LEFT_OUT = ("seconds",)  # times


def numbers_of(value, depth=0):
    """A value as JSON has it: floats by all their digits, arrays by shape, type and hash, objects by their properties."""
    if value is None or isinstance(value, (str, bool, int)):
        return value
    if isinstance(value, (float, numpy.generic)):
        return repr(value.item() if isinstance(value, numpy.generic) else value)
    if isinstance(value, numpy.ndarray):
        return f"{value.dtype} {value.shape} {hashlib.sha256(numpy.ascontiguousarray(value).tobytes()).hexdigest()[:16]}"
    if isinstance(value, dict):
        return {str(key): numbers_of(one, depth + 1) for key, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [numbers_of(one, depth + 1) for one in value]
    if depth > 3:
        raise TypeError(f"properties of properties: {type(value)}")
    return {name: numbers_of(getattr(value, name), depth + 1) for name, _ in inspect.getmembers(type(value), inspect.isdatadescriptor)
            if not name.startswith("_") and name not in LEFT_OUT}


def main():
    world = suffuse.read_packing(EXAMPLES / "replay/packing.csv", cell=CELL)
    numbers = {"read": numbers_of(world)}
    numbers["settle"] = numbers_of(world.settle(suffuse.Loading(stress="100 kPa")))
    numbers["settled"] = numbers_of(world)
    reference, water = world.copy(), suffuse.seep(world, gradient=0.05, direction="x", tensor=True)
    numbers["water"] = numbers_of(water)
    numbers["network constrictions"] = numbers_of(water.network.constrictions())
    numbers["widest paths"] = numbers_of(water.network.widest_paths("x"))
    numbers["grid"] = numbers_of(suffuse.resolve_flow(world, gradient=0.05, boxes_across=4))
    loading = suffuse.Loading(strain_rate=(None, None, 10), stress=("100 kPa", "100 kPa", None))
    for mode in ("reference", "fast"):
        stepped = reference.copy()
        numbers[f"stress after steps, {mode}"] = numbers_of(stepped.step(500, loading, mode=mode))
        numbers[f"steps, {mode}"] = numbers_of(stepped)
        numbers[f"measures, {mode}"] = numbers_of(stepped.measure())
    numbers["relax"] = numbers_of(reference.relax(1e-6))
    numbers["triaxial"] = numbers_of(reference.copy().triaxial(0.01, rows=20))
    numbers["stress probe"] = numbers_of(reference.copy().stress_probe(directions=4))
    removed = reference.copy()
    numbers["removed"] = removed.remove(removed.grains.radius < numpy.quantile(removed.grains.radius, 0.2))
    numbers["what is left"] = numbers_of(removed)
    sizes = numpy.concatenate([numpy.full(60, 0.5e-3), numpy.full(200, 0.2e-3)])
    cloud = suffuse.make_cloud(sizes, porosity=0.6, fine=sizes < 0.3e-3, seed=5)
    numbers["cloud"] = numbers_of(cloud)
    numbers["compact"] = numbers_of(cloud.compact("50 kPa", protocol="swift"))
    numbers["compacted"] = numbers_of(cloud)
    numbers["constrictions"] = numbers_of(suffuse.constrictions(cloud, of="coarse"))
    numbers["assess"] = numbers_of(suffuse.assess(EXAMPLES / "silty-sand-2016/data/silt.csv", gradient=0.3))
    numbers["schema"] = numbers_of([{"table": key.table, "name": key.name, "default": key.default} for key in suffuse.schema()])
    json.dump(numbers, fp=open(1, "w", encoding="utf-8"), indent=1)


main()
