"""The critical state of equal spheres by Yade, under the conditions of validation/critical_state.py (friction 0.3, no
rolling resistance): `yade -n -x -j1 critical_state_yade.py FOLDER START:SEED...`, START being dense or loose.

Each sample leaves its curve in FOLDER/START_SEED.csv; those that are there already are not measured again. Yade runs this
file with its own names (O, utils, pack, the engine classes) already there. Dense: no friction while compacted; loose: that
of the test.
"""
import csv
import math
import pathlib
import statistics
import sys

GRAINS, RADIUS, DENSITY = 1000, 0.1e-3, 2600.0
PRESSURE, STIFFNESS, SHEAR_RATIO, FRICTION = 100e3, 2000, 0.42, 0.3
RATE = 1e-3 * math.sqrt(PRESSURE / DENSITY) / (2 * RADIUS)  # inertial number 1e-3
STRAIN, CRITICAL, ROWS = 0.5, 0.4, 500
CLOUD = 0.74  # porosity of the cloud: random insertion without moving spheres gets no denser than 0.7
STEPS_AT_MOST = 400_000  # of one stage of the preparation


def build_scene(seed, friction):
    O.reset()
    O.periodic = True
    solid = GRAINS * 4 / 3 * math.pi * RADIUS**3
    side = (solid / (1 - CLOUD)) ** (1 / 3)
    O.cell.setBox(side, side, side)
    # k_n = 2 E r1 r2/(r1 + r2) = E r, so that k_n/(p d) = E/(2 p); k_s = poisson k_n.
    young = 2 * STIFFNESS * PRESSURE
    O.materials.append(FrictMat(young=young, poisson=SHEAR_RATIO, density=DENSITY, frictionAngle=math.atan(friction)))
    cloud = pack.SpherePack()
    placed = cloud.makeCloud((0, 0, 0), (side, side, side), rMean=RADIUS, rRelFuzz=0, num=GRAINS, periodic=True, seed=seed)
    assert placed == GRAINS, placed
    O.bodies.append([utils.sphere(x, r, material=0) for x, r in cloud])
    servo = PeriTriaxController(
        dynCell=True,
        # [kg/m]; with the 2 M/L of the other comparisons, the lateral stress would wander by 11 % instead of 0.2 %.
        mass=sum(b.state.mass for b in O.bodies) / (4 * side),
        goal=(-PRESSURE,) * 3,
        stressMask=7,
        growDamping=0.25,
        maxUnbalanced=0,  # never done
    )
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.1 * RADIUS),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom()],
            [Ip2_FrictMat_FrictMat_FrictPhys()],
            [Law2_ScGeom_FrictPhys_CundallStrack()],
        ),
        servo,
        NewtonIntegrator(damping=0.2),
    ]
    O.dt = 0.4 * utils.PWaveTimeStep()
    return servo, solid


def run_until(servo, rate, done):
    """With the strain rate capped."""
    servo.maxStrainRate = (rate,) * 3
    begin = O.iter
    while not done():
        assert O.iter - begin < STEPS_AT_MOST, (rate, list(servo.stress), utils.unbalancedForce())
        O.run(500, True)


def prepare(seed, start):
    """A sample at rest at PRESSURE, its friction that of the test."""
    servo, solid = build_scene(seed, 0 if start == "dense" else FRICTION)

    def loaded():
        return min(-s for s in servo.stress) > 0.05 * PRESSURE

    def quiet():
        off = max(abs(-s / PRESSURE - 1) for s in servo.stress)
        return off < 1e-3 and utils.unbalancedForce() < 1e-3

    run_until(servo, 250, loaded)
    run_until(servo, 20, quiet)
    O.materials[0].frictionAngle = math.atan(FRICTION)
    for contact in O.interactions:
        contact.phys.tangensOfFrictionAngle = FRICTION
    O.run(500, True)
    run_until(servo, 20, quiet)
    return servo, solid


def coordination():
    """Contacts per grain, grains with fewer than two and their contacts left out [Thornton 2000]."""
    of = [0] * GRAINS
    for contact in O.interactions:
        of[contact.id1] += 1
        of[contact.id2] += 1
    return (sum(of) - of.count(1)) / (GRAINS - of.count(0) - of.count(1))


def record():
    lateral, axial = -0.5 * (servo.stress[0] + servo.stress[1]), -servo.stress[2]
    rows.append({
        "strain": -servo.strain[2],
        "ratio": 3 * (axial - lateral) / (axial + 2 * lateral),
        "void_ratio": O.cell.volume / solid - 1,
        "z": coordination(),
        "lateral": lateral,
        "unbalanced": utils.unbalancedForce(),
    })


def test(seed, start):
    """The curve of one sample in drained compression."""
    global servo, solid, rows  # for `record`, which Yade calls
    servo, solid = prepare(seed, start)
    rows, prepared = [], O.iter
    O.cell.trsf = Matrix3.Identity  # strains from here
    servo.stressMask = 0b011  # stresses held on x and y; on z towards a far strain, at the rate's cap
    servo.goal = (-PRESSURE, -PRESSURE, -2 * STRAIN)
    servo.maxStrainRate = (2 * RATE, 2 * RATE, RATE)
    every = round(STRAIN / ROWS / (RATE * O.dt))
    O.run(1, True)
    record()
    O.engines = O.engines + [PyRunner(command="record()", iterPeriod=every, initRun=False)]
    O.run(math.ceil(STRAIN / (RATE * O.dt)), True)
    print(f"{start} {seed}: {prepared} steps of preparation, {O.iter - prepared} of the test", file=sys.stderr, flush=True)
    return rows


def print_table(folder):
    print("sample      e start  Z_m start  q/p peak  q/p    e      Z_m")
    for start in ("dense", "loose"):
        means = []
        for path in sorted(folder.glob(f"{start}_*.csv"), key=lambda path: int(path.stem.split("_")[1])):
            with open(path, newline="") as file:
                curve = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(file)]
            late = [row for row in curve if row["strain"] >= CRITICAL]
            found = {name: statistics.fmean(row[name] for row in late) for name in ("ratio", "void_ratio", "z")}
            means.append([curve[0]["void_ratio"], curve[0]["z"], max(row["ratio"] for row in curve), *found.values()])
            print("{:10}  {:.3f}    {:.2f}       {:.3f}     {:.3f}  {:.3f}  {:.2f}".format(path.stem, *means[-1]))
        if len(means) > 1:
            for name, values in zip(("e start", "Z_m start", "q/p peak", "q/p", "e", "Z_m"), zip(*means)):
                error = statistics.stdev(values) / math.sqrt(len(values))
                print(f"{start}, {len(values)} samples: {name} {statistics.fmean(values):.4f} ± {error:.4f} (error)")


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for sample in sys.argv[2:]:
        start, seed = sample.split(":")
        path = folder / f"{start}_{seed}.csv"
        if path.exists():
            continue
        curve = test(int(seed), start)
        with open(path, "w", newline="") as file:
            writer = csv.DictWriter(file, list(curve[0]), lineterminator="\n")
            writer.writeheader()
            writer.writerows(curve)
    print_table(folder)


main()
