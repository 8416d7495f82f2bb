"""Yade's side of the comparisons: `yade -n -x -j2 inside.py CASE.json`.

Yade runs this file with its own names (O, utils, the engine classes) already there. Commands come in, one a line, on
standard input; answers go out as lines "@{...}", because Yade prints lines of its own:
    settle     isotropic servo until the stress is met and the packing is quiet; then the axial shear is switched on
    window N   N steps of shear, timed; answers with the seconds and the state after them
    quit
The time of a window is that of O.run alone: no Python runs inside it, and the state is measured outside the clock.
"""
import json
import math
import sys
import time


def build_scene(case):
    law, pressure = case["law"], case["pressure"]
    O.periodic = True
    O.cell.setBox(*case["cell"])
    O.materials.append(CohFrictMat(momentRotationLaw=True, isCohesive=False, **law["material"]))
    O.bodies.append([utils.sphere((x, y, z), r, material=0) for x, y, z, r in case["grains"]])
    servo = PeriTriaxController(
        dynCell=True,
        # [kg/m]; Yade's default, in kg, makes the servo of a millimetric sample unstable.
        mass=2 * sum(b.state.mass for b in O.bodies) / case["cell"][0],
        goal=(-pressure,) * 3,
        stressMask=7,
        maxStrainRate=(20, 20, 20),
        growDamping=0.25,
        maxUnbalanced=0,
    )
    # The margin that gives Yade its best speed on such packings; its default stores 1.7 times as many pairs.
    margin = 0.05 * min(r for _, _, _, r in case["grains"])
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=margin),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom6D()],
            [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()],
            [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True, useIncrementalForm=True)],
        ),
        servo,
        NewtonIntegrator(damping=law["damping"]),
    ]
    O.dt = case["time_step"]
    return servo


def state():
    stress = utils.getStress()
    solid = sum(4 / 3 * math.pi * b.shape.radius**3 for b in O.bodies)
    contacts = sum(1 for i in O.interactions if i.isReal)
    return {
        "grains": len(O.bodies),
        "contacts": contacts,
        "candidates": len(O.interactions),
        "void_ratio": O.cell.volume / solid - 1,
        "coordination": 2 * contacts / len(O.bodies),
        "stress": [-stress[a][a] for a in range(3)],
        "unbalanced_force_yade": utils.unbalancedForce(),
        "steps": O.iter,
    }


def settle(case, servo):
    quiet = False
    while not quiet and O.iter < case["settle_steps_at_most"]:
        O.run(500, True)
        now = state()
        off = max(abs(s / case["pressure"] - 1) for s in now["stress"])
        quiet = off < case["stress_tolerance"] and now["unbalanced_force_yade"] < case["unbalanced_force"]
    servo.stressMask = 0b011  # stresses held on x and y, strain rate imposed on z: towards a far goal, at the rate's cap
    servo.goal = (-case["pressure"], -case["pressure"], -0.5)
    servo.maxStrainRate = (60, 60, case["strain_rate"])
    return quiet


def answer(seconds, **more):
    print("@" + json.dumps({"seconds": seconds, "threads": O.numThreads, **more, **state()}), flush=True)


def main():
    with open(sys.argv[1]) as file:
        case = json.load(file)
    servo = build_scene(case)
    for line in sys.stdin:
        verb, *steps = line.split()
        begin, processor = time.perf_counter(), time.process_time()
        if verb == "settle":
            quiet = settle(case, servo)
            answer(time.perf_counter() - begin, quiet=quiet)
        elif verb == "window":
            O.run(int(steps[0]), True)
            seconds, processor = time.perf_counter() - begin, time.process_time() - processor
            answer(seconds, processor_seconds=processor, window=int(steps[0]))
        else:
            break


main()
