#!/usr/bin/env python3
"""Prints the critical states and the stress-dilatancy of a run of critical-state.toml as Markdown tables, and draws
them: critical_state.py RUN_FOLDER [FIGURE.svg]. Needs nothing but Python's own library."""

import csv
import math
import pathlib
import sys

TESTS = {"shear-dense": ("dense", "#7f5b10"), "shear-loose": ("loose", "#56606c"), "shear-eroded": ("eroded", "#b3261e")}
LAST = 0.1  # of axial strain: the critical state
STEP = 0.02  # of axial strain: one point of the stress-dilatancy
TRANSIENT = 0.02  # of axial strain, left out of the fit: the stress rises before the sample yields


def read_test(path):
    """Axial and volumetric strain, q/p, q [kPa], void ratio, mechanical coordination; one tuple a row."""
    rows = []
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            number = {key: float(value) for key, value in row.items()}
            stress = [number[f"stress_{a}"] for a in (1, 2, 3)]
            q, p = stress[2] - (stress[0] + stress[1]) / 2, sum(stress) / 3
            volumetric = sum(number[f"strain_{a}"] for a in (1, 2, 3))
            rows.append([number["strain_3"], volumetric, q / p, q / 1e3, number["void_ratio"]])
    first = rows[0][:2]
    return [[row[0] - first[0], row[1] - first[1], *row[2:]] for row in rows]


def mean(values):
    return sum(values) / len(values)


def line(points):
    """Least squares: value at 0, slope."""
    x, y = mean([a for a, _ in points]), mean([b for _, b in points])
    slope = sum((a - x) * (b - y) for a, b in points) / sum((a - x) ** 2 for a, _ in points)
    return y - slope * x, slope


def stress_dilatancy(rows):
    """Points (strain, D, q/p), each over STEP of axial strain; D = -d eps_v/d eps_1."""
    points = []
    for k in range(int(rows[-1][0] / STEP + 1e-9)):
        part = [row for row in rows if k * STEP <= row[0] <= (k + 1) * STEP]
        if len(part) > 5:
            points.append(((k + 0.5) * STEP, -line([(r[0], r[1]) for r in part])[1], mean([r[2] for r in part])))
    return points


def print_tables(tests):
    print("| sample | seed | highest q [kPa] | at [%] | q at 10 % [kPa] | q left [kPa] | q/p left | e at first | e left |")
    print("|---|---|---|---|---|---|---|---|---|")
    for (name, seed), rows in sorted(tests.items()):
        peak = max(rows, key=lambda row: row[3])
        tenth = min(rows, key=lambda row: abs(row[0] - 0.1))
        last = [row for row in rows if row[0] >= rows[-1][0] - LAST]
        print(f"| {TESTS[name][0]} | {seed} | {peak[3]:.0f} | {100 * peak[0]:.1f} | {tenth[3]:.0f} | "
              f"{mean([r[3] for r in last]):.0f} | {mean([r[2] for r in last]):.2f} | {rows[0][4]:.3f} | "
              f"{mean([r[4] for r in last]):.3f} |")
    print("\n| sample | q/p at D = 0 | slope | off the line [-] |\n|---|---|---|---|")
    every = []
    for name, (words, _) in TESTS.items():
        points = [p[1:] for key, rows in tests.items() if key[0] == name
                  for p in stress_dilatancy(rows) if p[0] > TRANSIENT]
        every += points
        print_fit(words, points)
    print_fit("all", every)
    return line(every)


def print_fit(words, points):
    start, slope = line(points)
    off = math.sqrt(mean([(y - start - slope * x) ** 2 for x, y in points]))
    print(f"| {words} | {start:.2f} | {slope:.2f} | {off:.2f} |")


class Panel:
    """Axes within an SVG, from data to pixels."""

    def __init__(self, left, x, y, title, x_title):
        self.left, self.x, self.y = left, x, y
        self.parts = [f'<text x="{left}" y="18" font-weight="600">{title}</text>',
                      f'<text x="{left + 260}" y="292" text-anchor="end">{x_title}</text>']
        for tick in y[2]:
            self.parts.append(f'<path d="M{left} {self.v(tick):.1f}h260" stroke="#e7e5e0"/><text x="{left - 6}" '
                              f'y="{self.v(tick) + 4:.1f}" text-anchor="end">{tick:g}</text>')
        for tick in x[2]:
            self.parts.append(f'<text x="{self.h(tick):.1f}" y="272" text-anchor="middle">{tick:g}</text>')

    def h(self, value):
        return self.left + 260 * (value - self.x[0]) / (self.x[1] - self.x[0])

    def v(self, value):
        return 255 - 225 * (value - self.y[0]) / (self.y[1] - self.y[0])

    def curve(self, points, color, width=2, dash=""):
        path = " ".join(f"{self.h(x):.1f},{self.v(y):.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}" '
                          f'stroke-dasharray="{dash}"/>')

    def dots(self, points, color):
        self.parts += [f'<circle cx="{self.h(x):.1f}" cy="{self.v(y):.1f}" r="3" fill="{color}" fill-opacity="0.7"/>'
                       for x, y in points]


def draw(tests, fit, file):
    strain = (0, 45, (0, 10, 20, 30, 40))
    panels = [Panel(50, strain, (0, 1.8, (0, 0.4, 0.8, 1.2, 1.6)), "Stress ratio q/p [-]", "axial strain [%]"),
              Panel(380, strain, (0.65, 1, (0.7, 0.8, 0.9, 1)), "Void ratio e [-]", "axial strain [%]"),
              Panel(710, (-0.9, 0.8, (-0.8, -0.4, 0, 0.4, 0.8)), (0, 1.8, (0, 0.4, 0.8, 1.2, 1.6)),
                    "Stress ratio q/p [-] against dilatancy", "−dεᵥ/dε₁ [-]")]
    for (name, _), rows in sorted(tests.items()):
        color = TESTS[name][1]
        thin = rows[:: max(1, len(rows) // 120)]
        panels[0].curve([(100 * r[0], r[2]) for r in thin], color, 1.5)
        panels[1].curve([(100 * r[0], r[4]) for r in thin], color, 1.5)
        panels[2].dots([p[1:] for p in stress_dilatancy(rows) if p[0] > TRANSIENT], color)
    panels[2].curve([(x, fit[0] + fit[1] * x) for x in (-0.6, 0.75)], "#1b1d1f", 1.5, "5 4")
    legend = "".join(f'<text x="{90 + 110 * k}" y="318" fill="{color}" font-weight="600">{words}</text>'
                     for k, (words, color) in enumerate(TESTS.values()))
    body = "\n".join(part for panel in panels for part in panel.parts)
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 990 330" font-family="system-ui, sans-serif" '
                    f'font-size="13" fill="#1b1d1f"><rect width="990" height="330" fill="#ffffff"/>\n{body}\n{legend}\n'
                    "</svg>\n")


def main():
    folder = pathlib.Path(sys.argv[1])
    tests = {(path.parent.name, path.parent.parent.name.removeprefix("rep=")): read_test(path)
             for path in folder.glob("studies/shear/*/shear-*/history.csv")}
    fit = print_tables(tests)
    if len(sys.argv) > 2:
        draw(tests, fit, pathlib.Path(sys.argv[2]))


if __name__ == "__main__":
    main()
