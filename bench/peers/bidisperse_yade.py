"""Frictionless spheres of size ratio 4 with 20 % fines, pressed by Yade to a stiffness to pressure of 1000, for
validation/bidisperse.md: `yade -n -x -j1 bidisperse_yade.py SEED...`. Yade runs this file with its own names already there."""
import math
import sys

PRESSURE, STIFFNESS, DENSITY = 100e3, 1000, 2600.0
COARSE, FINE, COARSE_GRAINS, FINE_GRAINS = 0.2e-3, 0.05e-3, 150, 2400  # radii [m]
CLOUD = 0.8  # porosity


def solid_volume():
    return sum(4 / 3 * math.pi * b.shape.radius**3 for b in O.bodies)


def build_scene(seed):
    O.reset()
    O.periodic = True
    solid = 4 / 3 * math.pi * (COARSE_GRAINS * COARSE**3 + FINE_GRAINS * FINE**3)
    side = (solid / (1 - CLOUD)) ** (1 / 3)
    O.cell.setBox(side, side, side)
    O.materials.append(FrictMat(young=2 * STIFFNESS * PRESSURE, poisson=1e-3, density=DENSITY, frictionAngle=0))
    cloud = pack.SpherePack()
    for radius, grains, own_seed in ((COARSE, COARSE_GRAINS, seed), (FINE, FINE_GRAINS, seed + 100)):
        cloud.makeCloud(
            (0, 0, 0), (side, side, side), rMean=radius, rRelFuzz=0, num=grains, periodic=True, seed=own_seed
        )
    assert len(cloud) == COARSE_GRAINS + FINE_GRAINS, len(cloud)
    O.bodies.append([utils.sphere(x, r, material=0) for x, r in cloud])
    servo = PeriTriaxController(
        dynCell=True,
        mass=sum(b.state.mass for b in O.bodies) / (4 * side),  # [kg/m]; holds the stress to some thousandths
        goal=(-PRESSURE,) * 3,
        stressMask=7,
        growDamping=0.25,
        maxUnbalanced=0,  # never done
    )
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.2 * FINE),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
        servo,
        NewtonIntegrator(damping=0.2),
    ]
    O.dt = 0.4 * utils.PWaveTimeStep()
    return servo


def run_until(servo, rate, done):
    servo.maxStrainRate = (rate,) * 3
    while not done():
        O.run(500, True)


for seed in map(int, sys.argv[1:]):
    servo = build_scene(seed)
    run_until(servo, 250, lambda: min(-s for s in servo.stress) > 0.05 * PRESSURE)
    run_until(servo, 60, lambda: min(-s for s in servo.stress) > 0.5 * PRESSURE)
    run_until(
        servo, 20,
        lambda: max(abs(-s / PRESSURE - 1) for s in servo.stress) < 1e-3 and utils.unbalancedForce() < 1e-3,
    )
    print(f"seed {seed}: solid fraction {solid_volume() / O.cell.volume:.4f} after {O.iter} steps", flush=True)
