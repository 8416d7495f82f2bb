#!/usr/bin/env python3
"""page/check_assess.py PROGRAM: the page of `suffuse assess --page` computes what the program does.

Makes 200 random gradings, closed and open, writes the page for them, opens it in Chromium and compares every number
and verdict of every criterion with `suffuse assess --json`. Then what the page shows of an α that is known or not, and
that one soil prints on one sheet, as pdftotext reads it. Exit code 77 without Chromium."""

import html
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

COUNT = 200
TOLERANCE = 1e-9  # relative: the same formulas in the same order, but for the rounding of powers and logarithms


def grading(number):
    """Sieves and percents of a soil: steep, wide, with a gap, with a trace, closed or open at either end."""
    draw = random.Random(number)
    size = 10 ** draw.uniform(-3, 0)
    sizes, shares = [], []
    for _ in range(draw.randint(3, 12)):
        sizes.append(size)
        size *= 10 ** draw.uniform(0.1, 0.45)
        shares.append(draw.choice([draw.uniform(0, 100), draw.uniform(0, 100), 0.1, 99.9]))
    shares.sort()
    if draw.random() < 0.6:
        shares[0] = 0
    if draw.random() < 0.7:
        shares[-1] = 100
    if draw.random() < 0.4 and len(shares) > 4:  # a gap
        gap = draw.randint(1, len(shares) - 3)
        shares[gap + 1] = shares[gap]
    shares[-1] = max(shares[-1], 5, shares[0] + 1)
    return "d [mm],passing [%]\n" + "".join(f"{d:.5g},{f:.4g}\n" for d, f in zip(sizes, shares))


def same(ours, theirs):
    if ours is None or theirs is None:
        return ours is None and theirs is None
    return abs(ours - theirs) <= TOLERANCE * max(1, abs(ours))


def check_view(program, browser, folder):
    """What is wrong with the page of one soil: a slider that claims to know α, or what is wrong on paper."""
    Path(folder, "dyke.csv").write_text("d [mm],passing [%]\n0.002,0\n0.063,14\n0.63,27\n2,33\n20,76\n63,100\n")
    wrong = []
    opened = [browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/chromium"]
    for alpha in [None, "0.2"]:
        options = ["-i", "0.3"] + (["--alpha", alpha] if alpha else [])
        subprocess.run([program, "assess", "dyke.csv", *options, "--page", "-o", "one.html"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        page = Path(folder, "one.html").as_uri()
        dom = subprocess.run([*opened, "--dump-dom", page], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=300, text=True).stdout
        row = re.search(r'<label class="([^"]*)" id="alpha-row">', dom)
        if row is None or ("unset" in row.group(1)) != (alpha is None):
            wrong.append(f"α {alpha}: its slider is {'not ' if alpha is None else ''}shown as not set")
        if bool(re.search(r'<button id="unknown"[^>]* hidden', dom)) != (alpha is None):
            wrong.append(f"α {alpha}: the button that forgets it is {'shown' if alpha is None else 'hidden'}")
        if "specified 0.30" not in dom or "heave 0.99" not in dom:
            wrong.append("the gradients are not drawn on their line")
        if 'class="cell"' not in dom or 'class="place"' not in dom or "The ring is this soil" not in dom:
            wrong.append("the map of the atlas lacks its cells or the soil")
    return wrong + check_flow(program, opened, folder) + check_atlas(program, opened, folder) + check_print(program, opened, folder)


def check_flow(program, opened, folder):
    """What is wrong with the page of a soil whose water does not rise, or whose gradient nobody gave."""
    Path(folder, "at.csv").write_text("d [mm],passing [%]\n0.18,0\n0.22,17\n0.8,17\n1.3,100\n")
    wrong = []
    for options, shown, hidden in [
        ("-i 0.9 --flow level --porosity 0.3 --alpha 0.3", ["of level flow", ">0.90<", ">0.30<", "no limits of level flow", "(atlas, level flow)"], ["factor of safety"]),
        ("-i 0.9 --flow down", ["of downward flow", "no limits of downward flow"], ["factor of safety", "(atlas"]),
        ("-i 0.5 --flow 30deg", ["of rising flow", "specified 0.50", "limits of vertical flow"], ["factor of safety"]),
        ("-i 1.1 --flow 30deg", ["factor of safety 0.9"], []),
        ("", ["not given", "heave 0.99", "(atlas)."], ["factor of safety", "specified", "at least"]),
    ]:
        subprocess.run([program, "assess", "at.csv", *options.split(), "--page", "-o", "flow.html"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        page = Path(folder, "flow.html").as_uri()
        dom = subprocess.run([*opened, "--dump-dom", page], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=300, text=True).stdout
        text = dom.split("<script")[0]
        wrong += [f"{options}: the page lacks “{part}”" for part in shown if part not in text]
        wrong += [f"{options}: the page says “{part}”" for part in hidden if part.lower() in text.lower()]
    return wrong


def check_atlas(program, opened, folder):
    """What is wrong with the headline of a soil within the atlas: other gradients than those of `assess --json`."""
    wrong = []
    for fines, sizes in ("12", "0.1385 0.1692 0.9 1.1"), ("31", "0.095238 0.105 0.380952 0.42"):  # not all samples around the second move
        wrong += check_headline(program, opened, folder, sizes.split(), fines)
    return wrong


def factor(number):
    """As the program writes a factor of safety: never rounded to 1 from below."""
    return f"{min(number, 0.99):.2f}" if number < 1 else f"{number:.1f}"


def check_headline(program, opened, folder, sizes, fines):
    """What is wrong with the headline of a soil of two fractions."""
    Path(folder, "within.csv").write_text("d [mm],passing [%]\n" + "".join(f"{d},{f}\n" for d, f in zip(sizes, ["0", fines, fines, "100"])))
    command = [program, "assess", "within.csv", "-i", "0.3", "--page", "-o", "within.html", "--json"]
    soil = json.loads(subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE).stdout)["soils"][0]
    page = Path(folder, "within.html").as_uri()
    dom = subprocess.run([*opened, "--dump-dom", page], check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=300, text=True).stdout
    entries = [entry for entry in soil["atlas"] if entry["flow"] == "up" and entry["inside"]]
    ours = sorted(entry["i1"] or entry["lower_bounds"]["i1"] for entry in entries)
    least = "at least " if any(entry["i1"] is None for entry in entries) else ""
    gradients, factors = f"{ours[0]:.2f} to {least}{ours[-1]:.2f} (atlas)", f"safety {factor(ours[0] / 0.3)} to {least}{factor(ours[-1] / 0.3)}."
    return [] if gradients in dom and factors in dom else [f"the headline lacks “{gradients}” or “{factors}”"]


def check_print(program, opened, folder):
    """What is wrong on paper: a soil on more than one sheet, a table that is cut, a control."""
    curve = "0.063,14\n0.63,27\n2,33\n20,76\n63,100\n"  # open at its end: every criterion has its remark
    Path(folder, "two.csv").write_text("".join(f"Sample: TP{k}\nd [mm],passing [%]\n{curve}\n" for k in (1, 2)))
    wrong = []
    for file, most in {"dyke.csv": 1, "two.csv": 2}.items():
        subprocess.run([program, "assess", file, "-i", "0.3", "--page", "-o", "print.html"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        pdf, page = Path(folder, "print.pdf"), Path(folder, "print.html").as_uri()
        subprocess.run([*opened, f"--print-to-pdf={pdf}", page], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=300)
        sheets = len(re.findall(rb"/Type\s*/Page\b", pdf.read_bytes()))
        if sheets != most:
            wrong.append(f"{file} prints on {sheets} sheets, not on {most}")
        text = subprocess.run(["pdftotext", str(pdf), "-"], check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
        if most > 1 and len(re.findall(r"\d of \d$", text, re.M)) < most + 1:  # a row's last cell; pages are numbered, too
            wrong.append(f"{file} prints its table without its last column")
        if re.search(r"^sample\s+(two|TP)", text, re.M) or "The curve as given" in text:
            wrong.append(f"{file} prints controls")
    return wrong


def main():
    program = str(Path(sys.argv[1]).resolve())
    browser = os.environ.get("SUFFUSE_CHROMIUM") or shutil.which("chromium") or shutil.which("chromium-browser")
    if not browser:
        print("no Chromium found; install the package chromium, or name it in SUFFUSE_CHROMIUM", file=sys.stderr)
        return 77
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for k in range(COUNT):
            files.append(f"{k:03}.csv")
            Path(folder, files[-1]).write_text(grading(k))
        options = ["-i", "0.35", "--porosity", "0.37", "--density", "2700kg/m^3"]
        command = [program, "assess", *files, *options, "--page", "-o", "all.html", "--json"]
        ours = json.loads(subprocess.run(command, cwd=folder, check=True, stdout=subprocess.PIPE).stdout)["soils"]
        page = Path(folder, "all.html").as_uri() + "#numbers"
        opened = [browser, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/chromium", "--dump-dom", page]
        dom = subprocess.run(opened, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, timeout=300, text=True).stdout
        found = re.search(r'<pre id="numbers">(.*?)</pre>', dom, re.S)
        if not found:
            print("the page did not compute its numbers", file=sys.stderr)
            return 1
        theirs = json.loads(html.unescape(found.group(1)))
        wrong = check_view(program, browser, folder)
    compared = 0
    for soil, page_soil in zip(ours, theirs, strict=True):
        on_page = {other["id"]: other for other in page_soil["criteria"]}
        for criterion in soil["criteria"]:
            other = on_page.get(criterion["id"])
            if other is None:
                if criterion["verified"]:
                    wrong.append(f"{soil['soil']} {criterion['id']} is not on the page")
                continue
            compared += 1
            pairs = [(criterion[key], other.get(key)) for key in ("value", "measured", "limit", "upper")]
            if criterion["verdict"] == "cannot say" or criterion["value"] is None:
                pairs = pairs[:2]  # a limit is shown, and never used
            if any(criterion[key] != other[key] for key in ("verdict", "verified")) or not all(same(a, b) for a, b in pairs):
                wrong.append(f"{soil['soil']} {criterion['id']}: {criterion} and on the page {other}")
        heave, fines = soil["gradients"]
        compared += 2
        if not same(heave["limit"], page_soil["gradients"]["heave"]):
            wrong.append(f"{soil['soil']}: heave {heave['limit']} and on the page {page_soil['gradients']['heave']}")
        if heave["verdict"] == "stable" and not same(fines["limit"], page_soil["gradients"].get("fines")):
            wrong.append(f"{soil['soil']}: fines {fines['limit']} and on the page {page_soil['gradients'].get('fines')}")
    for text in wrong[:10]:
        print(text, file=sys.stderr)
    print(f"{compared} numbers and verdicts of {len(ours)} gradings compared, {len(wrong)} differ")
    return 1 if wrong or compared < 1400 else 0


if __name__ == "__main__":
    sys.exit(main())
