#!/usr/bin/python3
"""Can LAMMPS prepare a sample over MPI that we go on with? The trial of docs/decisions/4-no-message-passing.md.

Ways to one state at 100 kPa, from the same cloud of grains. *ours*: this program alone. *cloud*: LAMMPS compresses the cloud to
60 kPa, we take its grains and contacts and go on. *grains*: the same without the contacts. *midway*: our sample rests at 20 kPa,
LAMMPS takes grains and contacts and goes on slowly to 60 kPa, and we take them back; *midway, ours*: the same by us.

LAMMPS reads contact memory from its own restart files only. So it writes one of our grains, and this script puts our memory
in: behind the numbers of a grain stand its partners, each with displacements that slid and rolled [pair_style granular].
"""
import argparse
import math
import os
import pathlib
import re
import shutil
import statistics
import struct
import subprocess
import time

import numpy
import suffuse

from lammps_peer import HERE, pair_coefficients

PRESSURE, TAKEN_AT, GIVEN_AT = 100e3, 20e3, 60e3  # [Pa]
FAST, SLOW = 250, 5  # [1/s]
RADII = numpy.linspace(75e-6, 125e-6, 9)  # a type of LAMMPS each [m]
MATERIAL = {"young": 356e6, "poisson": 0.42, "density": 2600, "frictionAngle": math.radians(37), "alphaKr": 7.5, "etaRoll": 0.22}
PART = struct.pack("<2i", -1, 47)  # what stands before the grains of a rank in a restart file, and then how many numbers


def our_material():
    return suffuse.Material(density=2600, modulus=356e6, shear_ratio=0.42, friction=math.radians(37), rolling_stiffness=7.5,
                            rolling_friction=0.22)


def cloud_of(grains, seed):
    radius = numpy.tile(RADII, grains // len(RADII))
    return suffuse.make_cloud(radius, 0.6, material=our_material(), seed=seed)


def springs(a, b):
    """Of LAMMPS for two radii: of sliding [N/m], of rolling [N/m], and the radius at which it rolls [m]."""
    shear = MATERIAL["poisson"] * 2 * MATERIAL["young"] * a * b / (a + b)
    reduced = a * b / (a + b)
    return shear, MATERIAL["alphaKr"] * shear * a * b / reduced**2, reduced


def write_for_lammps(world, folder, damping):
    """The grains as data, and the law between any two sizes."""
    grains = world.grains
    types = numpy.abs(grains.radius[:, None] - RADII).argmin(axis=1) + 1
    lines = ["grains", "", f"{len(grains)} atoms", f"{len(RADII)} atom types"]
    lines += [f"0 {world.cell[a, a]!r} {axis}lo {axis}hi" for a, axis in enumerate("xyz")]
    lines += ["", "Atoms # sphere", ""]
    lines += [f"{g + 1} {types[g]} {2 * r!r} 2600 {x!r} {y!r} {z!r}" for g, (r, (x, y, z)) in
              enumerate(zip(grains.radius.tolist(), grains.position.tolist()))]
    lines += ["", "Velocities", ""]
    lines += [f"{g + 1} " + " ".join(map(repr, v + w)) for g, (v, w) in enumerate(zip(grains.velocity.tolist(), grains.spin.tolist()))]
    (folder / "begin.data").write_text("\n".join(lines) + "\n")
    law = {"material": MATERIAL, "damping": damping}
    lines = ["pair_style granular"]
    lines += [f"pair_coeff {a + 1} {b + 1} {pair_coefficients(RADII[a], RADII[b], law)}" for a in range(len(RADII)) for b in range(a, len(RADII))]
    (folder / "law.lmp").write_text("\n".join(lines) + "\n")


def lammps(folder, given, begin, memory, rate, dt):
    words = {"begin": begin, "memory": memory, "compresses": int(rate > 0), "end": "end.restart", "dt": dt, "stress": GIVEN_AT, "rate": -rate,
             "blocks": 5000, "skin": 0.1 * RADII[0]}
    ranks = given.ranks if rate else 1  # one rank writes a restart file in one piece
    command = ["mpirun", "--allow-run-as-root", "-np", str(ranks), "lmp", "-in", HERE / "compress.lmp", "-log", "none"]
    for name, value in words.items():
        command += ["-var", name, str(value)]
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    done = subprocess.run([str(word) for word in command], cwd=folder, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0 or (rate and "@reached" not in done.stdout):
        raise SystemExit(f"LAMMPS failed in {folder}:\n{done.stdout[-1500:]}")
    return int(re.search(r"@reached (\d+)", done.stdout)[1]) if rate else 0


def rows_of(restart):
    """Where the row of each grain begins in a restart file that one rank wrote: a list of numbers is its last part."""
    end = len(restart) - len(b"LammpS RestartT\0")
    begin = restart.find(PART)
    while begin >= 0 and begin + 12 + 8 * struct.unpack_from("<i", restart, begin + 8)[0] != end:
        begin = restart.find(PART, begin + 1)
    if begin < 0:
        raise SystemExit("this version of LAMMPS writes other restart files")
    at = begin + 12
    while at < end:
        yield at
        at += 8 * int(struct.unpack_from("<d", restart, at)[0])


def remember(world, folder):
    """Puts what our contacts remember into a restart file that LAMMPS wrote of the same grains. @return contacts put in"""
    contacts, radius = world.contacts, world.grains.radius
    memory = {}
    for i, j, normal, shear, moment in zip(contacts.i.tolist(), contacts.j.tolist(), contacts.normal, contacts.shear_force, contacts.moment):
        slide, roll, reduced = springs(radius[i], radius[j])
        # With n from j to i, R n x f is the moment: f = moment x n / R, as both are at right angles. It is the same on j.
        rolled = numpy.cross(moment, normal) / (reduced * roll)
        memory[i + 1, j + 1] = (*(-shear / slide), *rolled)
        memory[j + 1, i + 1] = (*(shear / slide), *rolled)
    restart, put = bytearray((folder / "end.restart").read_bytes()), 0
    for at in rows_of(restart):
        tag, partners = struct.unpack_from("<q", restart, at + 8 * 4)[0], int(struct.unpack_from("<d", restart, at + 8 * 17)[0])
        for k in range(partners):
            where = at + 8 * (18 + 7 * k)
            known = memory.get((tag, int(struct.unpack_from("<d", restart, where)[0])))
            if known:
                struct.pack_into("<6d", restart, where + 8, *known)
                put += 1
    (folder / "begin.restart").write_bytes(restart)
    return put // 2


def taken_back(folder, with_contacts):
    contacts = folder / "contacts.dump" if with_contacts else None
    for dump in ("grains.dump", "contacts.dump"):  # of two steps the last
        text = (folder / dump).read_text()
        (folder / dump).write_text(text[text.rindex("ITEM: TIMESTEP"):])
    return suffuse.read_packing(folder / "grains.dump", material=our_material(), velocity_gradient=numpy.zeros((3, 3)), contacts=contacts)


def finish(world, way):
    """Goes on to 100 kPa. @return how the sample was before its first step, and what it came to"""
    begun = {"taken_at_kPa": world.mean_stress / 1e3, "unbalanced": world.balance["unbalanced_force"]}
    world.material = our_material()
    settled = world.settle(suffuse.Loading(stress=PRESSURE), mode="fast")
    found = world.measure()
    return {"way": way, **begun, "steps": settled["steps"], "e": world.void_ratio, "Z": found["coordination"],
            "p_kPa": world.mean_stress / 1e3}


def compressed(world, until, rate):
    """Ours, to a mean stress."""
    while world.mean_stress < until:
        world.step(50, suffuse.Loading(strain_rate=rate), mode="fast")
    return world


def at_rest(world):
    world.settle(suffuse.Loading(stress=TAKEN_AT), mode="fast")
    return world


def by_lammps(world, given, folder, dt, rate, memory):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    world.sort("id")
    write_for_lammps(world, folder, given.damping)
    begin = "begin.data"
    if memory:
        lammps(folder, given, begin, 0, 0, dt)
        print(f"  {remember(world, folder)} of {len(world.contacts)} contacts put into a restart file", flush=True)
        begin = "begin.restart"
    clock = time.perf_counter()
    steps = lammps(folder, given, begin, int(memory), rate, dt)
    print(f"  LAMMPS: {steps} steps, {time.perf_counter() - clock:.0f} s", flush=True)


def trial(given, seed):
    cloud = cloud_of(given.grains, seed)
    middle = at_rest(compressed(cloud.copy(), TAKEN_AT, FAST))
    dt = 0.5 * middle.stable_time_step()
    rows = []
    if not given.midway:
        rows.append(finish(compressed(cloud.copy(), GIVEN_AT, FAST), "ours"))
        by_lammps(cloud.copy(), given, given.folder / "cloud", dt, FAST, False)
        rows.append(finish(taken_back(given.folder / "cloud", True), "cloud"))
        rows.append(finish(taken_back(given.folder / "cloud", False), "grains"))
    by_lammps(middle.copy(), given, given.folder / "midway", dt, SLOW, True)
    rows.append(finish(taken_back(given.folder / "midway", True), "midway"))
    rows.append(finish(taken_back(given.folder / "midway", False), "midway, grains"))
    rows.append(finish(compressed(middle, GIVEN_AT, SLOW), "midway, ours"))
    for row in rows:
        print(seed, "  ".join(f"{name} {value:.5g}" if isinstance(value, float) else f"{name} {value}" for name, value in row.items()), flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--grains", type=int, default=9000)
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--midway", action="store_true", help="only the ways from 20 to 60 kPa")
    parser.add_argument("--ranks", type=int, default=2)
    parser.add_argument("--damping", type=float, default=0.2, help="local damping whose loss the dashpots of LAMMPS imitate")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("build/peers/handover"))
    given = parser.parse_args()
    rows = [row for seed in range(1, given.seeds + 1) for row in trial(given, seed)]
    print("\n| way | void ratio | coordination |\n|---|---|---|")
    for way in dict.fromkeys(row["way"] for row in rows):
        cells = [f"{statistics.fmean(v):.4f} ± {statistics.stdev(v) if len(v) > 1 else 0:.4f}" for v in
                 ([row[name] for row in rows if row["way"] == way] for name in ("e", "Z"))]
        print(f"| {way} | {' | '.join(cells)} |")


main()
