#!/usr/bin/python3
"""Check that includes follow the table of layers (tools/layers.txt): `check_layers.py [ROOT]`.

A file of room M includes M itself and the rooms on M's line, those of suffuse/ always as "suffuse/module/file.hpp";
tests and benchmarks may also include tests/support. A heavy library is included by its rooms only. Every breach is
named with its place, and so is a call of what is found once, from anywhere else; exit code 1 if there is one.
"""
import pathlib
import re
import sys

OUTSIDE = ("apps", "python", "bench", "validation")  # of suffuse/, each a room of its own
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def read_table(path):
    """Three dictionaries: module -> modules that it may include, start of a library's include -> rooms that may, function
    that is called once -> the file that calls it."""
    tables, current = {"modules": {}, "libraries": {}, "found once": {}}, None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        if line.startswith("["):
            current = tables[line.strip("[]")]
            continue
        name, _, allowed = (part.strip() for part in line.partition(":"))
        above = list(tables["modules"])
        rooms = [r for r in above if r not in OUTSIDE] if allowed == "*" else allowed.split()
        if current is tables["modules"] and not set(rooms) <= set(above):
            sys.exit(f"{path}:{number}: {name} names {', '.join(sorted(set(rooms) - set(above)))}, not defined above it")
        current[name] = allowed if current is tables["found once"] else set(rooms)
    return tables["modules"], tables["libraries"], tables["found once"]


def includes(path):
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def complaint_about(header, quoted, room, is_test, modules, libraries):
    """What is wrong with including `header` from `room` (tests: any other folder), or None."""
    for start, rooms in libraries.items():
        if header.startswith(start) and not quoted and room not in rooms and not is_test:
            return f"<{header}> is let into {', '.join(sorted(rooms)) or 'tests'} only"
    is_inside = room in modules and room not in OUTSIDE
    parts = header.split("/")
    other = parts[1] if parts[0] == "suffuse" and len(parts) > 2 else parts[0]
    if parts[0] == "suffuse" and len(parts) == 2:
        return f"{header} is for users, never included inside suffuse/" if is_inside else None
    if parts[0] == "suffuse" and other not in modules:
        return f"{other} is not in the table of modules"
    if is_test and header.startswith("tests/support/"):
        return None
    if quoted and is_inside and parts[0] != "suffuse":
        return f'"{header}": write it as "suffuse/module/file.hpp"'
    if quoted and room in modules and other in modules and other not in modules[room] | {room}:
        allowed = ", ".join(m for m in modules if m in modules[room]) or "nothing"
        return f"{room} may include {allowed}; {other} is not among them"
    return None


def calls_outside(root, sources, function, caller):
    """Where `function` is called but for once in `caller`: calls are indented, declarations are not."""
    call = re.compile(rf"^\s+[^/]*\b{function}\(")
    places = [
        f"{path.relative_to(root)}:{number}"
        for path in sources
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1)
        if call.match(line)
    ]
    own = [place for place in places if place.startswith(caller + ":")]
    return [place for place in places if place not in own] + own[1:], bool(own)


def check_found_once(root, found_once):
    sources = [
        path
        for top in ("suffuse", "apps", "python")
        for path in sorted((root / top).rglob("*.cpp"))
        if not path.name.endswith((".test.cpp", ".bench.cpp"))
    ]
    complaints = []
    for function, caller in found_once.items():
        others, is_called = calls_outside(root, sources, function, caller)
        complaints += [f"{place}: {function} is called once, by {caller}; take what it found from there" for place in others]
        if not is_called:
            complaints.append(f"{caller}: does not call {function}, as tools/layers.txt says")
    return complaints


def check(root):
    modules, libraries, found_once = read_table(root / "tools" / "layers.txt")
    complaints, files = check_found_once(root, found_once), 0
    for top in ("suffuse", "apps", "tests", "validation", "bench", "python"):
        for path in sorted((root / top).rglob("*.[hc]pp")):
            place = path.relative_to(root)
            if "fixtures" in place.parts:
                continue
            files += 1
            room = place.parts[1] if top == "suffuse" and len(place.parts) > 2 else top
            if top == "suffuse" and len(place.parts) > 2 and room not in modules:
                complaints.append(f"{place}: {room} is not in the table of modules")
                continue
            is_test = path.name.endswith((".test.cpp", ".bench.cpp")) or top in ("tests", "validation", "bench")
            for number, quoted, header in includes(path):
                complaint = complaint_about(header, quoted, room, is_test, modules, libraries)
                if complaint:
                    complaints.append(f"{place}:{number}: {complaint}")
    return complaints, files


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent)
    complaints, files = check(root.resolve())
    if not files:
        sys.exit(f"{root}: no C++ file found")
    print(f"{files} files, {len(complaints)} complaints against the layers of tools/layers.txt", *complaints, sep="\n")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
