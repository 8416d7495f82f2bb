"""LAMMPS as a peer: `pair_style granular` of Debian's build (29 Sep 2021, GRANULAR without OPENMP), one MPI rank a processor.

The same as ours: grains, time step, normal and shear stiffness of every pair, friction, rolling stiffness and limit. LAMMPS
has one stiffness a pair of types, so every radius of the packing (or, of a continuous grading, every size class) is a type.
Its rolling spring acts at the reduced radius R = r1 r2 / (r1 + r2): a stiffness k and a limit mu give the moments k R^2 and
mu R Fn, hence k = 7.5 ks r1 r2 / R^2 and mu = 0.22 min(r) / R.

Not the same: the build has no local damping (`fix damping/cundall` came later). Instead each contact has the dashpots that
take from an oscillation what local damping d takes, d / pi of critical [Cundall 1987]. Lateral strain rates are constants in
the timed windows, found in an untimed one in which the stress is held: a barostat would cost LAMMPS a sum over all pairs at
each step, which ours and Yade pay. The next window starts from the settled state again, as ours does.
"""
import math
import os
import pathlib
import re
import time

import harness

HERE = pathlib.Path(__file__).resolve().parent / "lammps"
MOST_TYPES = 40
# Ways to find neighbors: style, and margin as a share of the smallest radius. The fastest in a trial is taken.
NEIGHBORS = [(style, margin) for style in ("bin", "multi") for margin in (0.025, 0.05, 0.1, 0.2)]
TRIAL = 600  # steps
WARM_UP = 200  # of them and of every window, untimed


def size_classes(radii):
    """A representative radius for each grain: its own, or its class's mean where there are too many."""
    if len(set(radii)) <= MOST_TYPES:
        return list(radii)
    low, high = math.log(min(radii)), math.log(max(radii))
    numbers = [min(MOST_TYPES - 1, int(MOST_TYPES * (math.log(r) - low) / (high - low))) for r in radii]
    members = {k: [r for r, number in zip(radii, numbers) if number == k] for k in set(numbers)}
    means = {k: sum(m) / len(m) for k, m in members.items()}
    return [means[number] for number in numbers]


def pair_coefficients(a, b, law):
    """Of two grains with radii a, b: as our law has them, in the words of LAMMPS."""
    material = law["material"]
    damping = law["damping"] / math.pi  # of critical
    reduced = a * b / (a + b)
    normal = 2 * material["young"] * reduced
    shear = material["poisson"] * normal
    rolling = material["alphaKr"] * shear * a * b / reduced**2
    masses = [4 / 3 * math.pi * r**3 * material["density"] for r in (a, b)]
    inertias = [0.4 * m * r**2 for m, r in zip(masses, (a, b))]
    both = lambda x: x[0] * x[1] / (x[0] + x[1])
    normal_damping = 2 * damping * math.sqrt(normal / both(masses))  # a unit of mass
    rolling_damping = 2 * damping * math.sqrt(rolling * both(inertias)) / reduced
    return (
        f"hooke {normal:.9g} {normal_damping:.9g} "
        f"tangential linear_history {shear:.9g} {math.sqrt(material['poisson']):.6g} {math.tan(material['frictionAngle']):.9g} "
        f"rolling sds {rolling:.9g} {rolling_damping:.9g} {material['etaRoll'] * min(a, b) / reduced:.9g} damping mass_velocity"
    )


class Lammps:
    name, title = "lammps", "LAMMPS"
    goes_on = False
    def __init__(self, case, threads, folder):
        self.case, self.threads, self.folder = case, threads, folder
        self.radii = [grain[3] for grain in case["grains"]]
        self.variables = {
            "here": HERE,
            "dt": case["time_step"],
            "pressure": case["pressure"],
            "warm_up": WARM_UP,
            **self.neighbors("bin", 0.1),
            "rate_z": -case["strain_rate"],
            "blocks": case["settle_steps_at_most"] // 500,
            "off": case["stress_tolerance"],
            "unbalanced": case["unbalanced_force"],
            # [Pa] scale of the sample's stiffness; with it the barostat closes the gap in about a hundred steps.
            "modulus": 0.3 * case["law"]["material"]["young"],
        }
        self.lateral = (0, 0)
        self.remarks = []
        self.write_input()

    def neighbors(self, style, margin):
        return {"style": style, "skin": margin * min(self.radii)}

    def write_input(self):
        classes = size_classes(self.radii)
        types = {r: k + 1 for k, r in enumerate(sorted(set(classes)))}
        density = self.case["law"]["material"]["density"]
        lines = ["grains", "", f"{len(classes)} atoms", f"{len(types)} atom types"]
        lines += [f"0 {edge!r} {axis}lo {axis}hi" for axis, edge in zip("xyz", self.case["cell"])]
        lines += ["", "Atoms # sphere", ""]
        for k, (x, y, z, r) in enumerate(self.case["grains"]):
            lines.append(f"{k + 1} {types[classes[k]]} {2 * r!r} {density} {x!r} {y!r} {z!r}")
        (self.folder / "packing.data").write_text("\n".join(lines) + "\n")
        law = ["pair_style granular"]
        for a, type_a in types.items():
            law += [f"pair_coeff {type_a} {types[b]} {pair_coefficients(a, b, self.case['law'])}" for b in types if b >= a]
        (self.folder / "law.lmp").write_text("\n".join(law) + "\n")

    def run(self, script, **more):
        command = ["mpirun", "-np", self.threads, "lmp", "-in", HERE / script, "-log", "none"]
        for name, value in {**self.variables, **more}.items():
            command += ["-var", name, value]
        allowed = {f"OMPI_ALLOW_RUN_AS_ROOT{tail}": "1" for tail in ("", "_CONFIRM")}
        environment = {**os.environ, "OMP_NUM_THREADS": "1", **allowed}
        output, _, _ = harness.run_alone(command, cwd=self.folder, env=environment)
        return output

    def settle(self):
        begin = time.perf_counter()
        output = self.run("settle.lmp")
        steps, quiet = re.search(r"@settled (\d+) (\d)", output).groups()
        seconds = time.perf_counter() - begin
        self.choose_neighbors()
        return {"steps": int(steps), "seconds": seconds, "quiet": quiet == "1"}

    def choose_neighbors(self):
        """By steps a second of processor time, which suffers least from others on the machine."""
        speed = {}
        for way in NEIGHBORS:
            self.variables.update(self.neighbors(*way))
            rate, processors = self.window(TRIAL)
            speed[way] = rate / processors
        best = max(speed, key=speed.get)
        self.variables.update(self.neighbors(*best))
        tried = ", ".join(f"{style} {margin}: {speed[style, margin] / speed[best]:.2f}" for style, margin in speed)
        self.remarks = [
            "LAMMPS: the same stiffnesses, friction, rolling limit and time step; dashpots for local damping; constant lateral strain rate",
            f"LAMMPS: neighbor style {best[0]}, margin {best[1]} of the smallest radius; speed of all tried against it: {tried}",
        ]

    def window(self, steps):
        """Steps a second, and the share of its processors that it had."""
        output = self.run("window.lmp", window=steps, held=0, rate_x=self.lateral[0], rate_y=self.lateral[1])
        seconds, processors = (float(re.findall(value_after, output)[1]) for value_after in (r"Loop time of (\S+) on", r"(\S+)% CPU use"))
        return (steps - WARM_UP) / seconds, processors / 100

    def measure(self, steps):
        if not any(self.lateral):
            output = self.run("window.lmp", window=steps, held=1, rate_x=0, rate_y=0)
            self.lateral = tuple(float(rate) for rate in re.search(r"@rates (\S+) (\S+)", output).groups())
        rate, processors = self.window(steps)
        return {"steps_per_second": rate, "processors": processors, **self.state()}

    def state(self):
        """From the two tables that window.lmp leaves: contacts, and grains with the net force on them."""
        volume, *stress = (float(x) for x in (self.folder / "state.txt").read_text().split())
        forces = [math.hypot(*map(float, line.split()[1:5])) for line in table(self.folder / "contacts.dump")]
        net = [math.hypot(*map(float, line.split()[:3])) for line in table(self.folder / "grains.dump")]
        solid = sum(4 / 3 * math.pi * r**3 for r in self.radii)
        return {
            "grains": len(net),
            "contacts": len(forces),
            "void_ratio": volume / solid - 1,
            "coordination": 2 * len(forces) / len(net),
            "stress": stress,
            "unbalanced_force_yade": (sum(net) / len(net)) / (sum(forces) / len(forces)),
        }

    def close(self):
        pass


def table(dump):
    """The rows of a dump's only frame."""
    lines = dump.read_text().splitlines()
    return lines[next(k for k, line in enumerate(lines) if re.match(r"ITEM: (ATOMS|ENTRIES) ", line)) + 1 :]
