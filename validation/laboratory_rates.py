"""The tests of a laboratory at four inertial numbers: the table of docs/how-to/test-a-soil.md. Takes half a minute."""

import time

import numpy as np
import suffuse

suffuse.set_threads(1)
sand = suffuse.make_cloud(np.random.default_rng(5).uniform(0.05e-3, 0.1e-3, 1000), seed=5)  # radii [m]
sand.material.friction = np.radians(30)
sand.compact("100 kPa", void_ratio=0.75, protocol="swift", void_ratio_tolerance=0.004)

for number in (4e-3, 2e-3, 1e-3, 5e-4):
    pace = {"inertial_number": number, "mode": "fast"}
    start = time.process_time()
    compression = sand.copy().triaxial("5 %", **pace)["response"]
    extension = sand.copy().triaxial("5 %", direction="extension", **pace)["response"]
    shear = sand.copy().shear("10 %", hold="stress", **pace)
    oedometer = sand.copy().oedometer(["400 kPa", "50 kPa"], **pace)
    cyclic = sand.copy().cyclic(csr=0.25, cycles=30, **pace)
    angles = np.degrees([compression["friction_angle"], extension["friction_angle"]])
    print(
        f"{number}  {angles[0]:.1f} and {angles[1]:.1f} deg  tau/sn {shear['peak_stress_ratio']:.3f}"
        f"  K0 {oedometer['k0']:.3f}  Cc {oedometer['compression_index']:.4f}  Cs {oedometer['swelling_index']:.4f}"
        f"  cycles {cyclic['cycles_to_liquefaction']}  {time.process_time() - start:.1f} s"
    )
