#!/usr/bin/python3
"""tools/mutate.py [--build DIR] [--again | --check] [WORD ...]: do the tests notice a small change?

Makes the changes of tools/mutants.toml one at a time in the working tree, builds the tests of the changed file's own
module, runs them, and takes the change back. A change that they notice is killed, and the first test that fails is named; one
that they pass is a survivor: its module lacks a test, or the list says why no test can tell. WORDs choose changes by a
part of their file's name or text. What was found is kept in DIR/mutants.json by the content of the module, so that a
second call goes on where the first was stopped; --again forgets it. DIR is build/release unless given. Exit code 1
where a change survived without a reason, or one that has a reason was killed.

--check only looks whether each change of the list is still one: it builds nothing.
"""

import argparse
import hashlib
import json
import pathlib
import re
import signal
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
LONGEST = 900  # [s] of a module's tests: a change that makes them hang is noticed


def module_of(mutant):
    return mutant["file"].split("/")[1]


def stamp_of(mutant):
    """Of the change and of all that its module's tests are made from."""
    digest = hashlib.sha256(json.dumps(mutant, sort_keys=True).encode())
    for folder in ("suffuse/" + module_of(mutant), "tests/sheets"):
        for path in sorted(path for path in (ROOT / folder).rglob("*") if path.is_file()):
            digest.update(path.name.encode() + path.read_bytes())
    return digest.hexdigest()


def complaint_about(mutant):
    """Why the list names no change; empty where it does."""
    path = ROOT / mutant["file"]
    count = path.read_text().count(mutant["was"]) if path.is_file() else 0
    if count != 1:
        return f"tools/mutants.toml: '{mutant['was']}' stands {count} times in {mutant['file']}, once is needed"
    return "" if mutant["was"] != mutant["becomes"] else f"tools/mutants.toml: '{mutant['was']}' becomes itself"


def check(mutants):
    complaints = [complaint for complaint in map(complaint_about, mutants) if complaint]
    print("\n".join(complaints + [f"{len(mutants)} changes, {len(complaints)} of them no change"]))
    return 1 if complaints else 0


def changed(text, mutant):
    if complaint := complaint_about(mutant):
        sys.exit(complaint)
    return text.replace(mutant["was"], mutant["becomes"])


def first_failure(output):
    found = re.search(r"^\[  FAILED  \] ([^\s,]+)", output, re.MULTILINE)
    return f" by {found[1]}" if found else ""


def verdict_of(mutant, build):
    """"killed by TEST", "survived" or "does not build"; the file is as it was afterwards, however this ends."""
    path = ROOT / mutant["file"]
    before = path.read_bytes()
    tests = f"suffuse_{module_of(mutant)}_test"
    try:
        path.write_text(changed(before.decode(), mutant))
        if subprocess.run(["ninja", "-C", build, tests], stdout=subprocess.DEVNULL).returncode != 0:
            return "does not build"
        command = [build / tests, "--gtest_brief=1", "--gtest_fail_fast"]
        run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, errors="replace", timeout=LONGEST)
        return "killed" + first_failure(run.stdout) if run.returncode else "survived"
    except subprocess.TimeoutExpired:
        return "killed"
    finally:
        path.write_bytes(before)


def is_as_listed(mutant, verdict):
    return verdict.split()[0] == ("survived" if "reason" in mutant else "killed")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("words", nargs="*")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    mutants = tomllib.loads((ROOT / "tools/mutants.toml").read_text())["mutant"]
    chosen = [m for m in mutants if all(word in m["file"] + m["was"] + m["becomes"] for word in options.words)]
    if options.check:
        return check(chosen)
    kept = options.build / "mutants.json"
    found = json.loads(kept.read_text()) if kept.exists() and not options.again else {}
    wrong = 0
    for number, mutant in enumerate(chosen, 1):
        stamp = stamp_of(mutant)
        verdict = found.get(stamp) or verdict_of(mutant, options.build)
        if verdict != "does not build":
            found[stamp] = verdict
        kept.write_text(json.dumps(found, indent=1))
        wrong += 0 if is_as_listed(mutant, verdict) else 1
        reason = f" ({mutant['reason']})" if "reason" in mutant else ""
        print(f"{number} of {len(chosen)}: {verdict}: {mutant['file']}: {mutant['was']} -> {mutant['becomes']}{reason}", flush=True)
    print(f"{len(chosen)} changes, {wrong} not as they should be")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
