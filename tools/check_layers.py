#!/usr/bin/python3
"""Check that includes follow the table of layers (tools/layers.txt): `check_layers.py [ROOT]`.

Under suffuse/, a file of module M includes M itself and the modules on M's line, always as "suffuse/module/file.hpp";
test and benchmark files may also include tests/support. A heavy library is included by its rooms only. Every breach is
named with its place; exit code 1 if there is one.
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def read_table(path):
    """Two dictionaries: module -> modules that it may include, start of a library's include -> rooms that may."""
    tables, current = {"modules": {}, "libraries": {}}, None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        if line.startswith("["):
            current = tables[line.strip("[]")]
            continue
        name, _, allowed = (part.strip() for part in line.partition(":"))
        above = list(tables["modules"])
        rooms = above if allowed == "*" else allowed.split()
        if current is tables["modules"] and not set(rooms) <= set(above):
            sys.exit(f"{path}:{number}: {name} names {', '.join(sorted(set(rooms) - set(above)))}, not defined above it")
        current[name] = set(rooms)
    return tables["modules"], tables["libraries"]


def includes(path):
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == '"', match.group(2)


def complaint_about(header, quoted, room, is_test, modules, libraries):
    """What is wrong with including `header` from module `room` (apps, tests: any other folder), or None."""
    for start, rooms in libraries.items():
        if header.startswith(start) and not quoted and room not in rooms and not is_test:
            return f"<{header}> is let into {', '.join(sorted(rooms)) or 'tests'} only"
    if header.startswith("suffuse/"):
        parts = header.split("/")
        if len(parts) == 2:
            return f"{header} is for users, never included inside suffuse/" if room in modules else None
        if parts[1] not in modules:
            return f"{parts[1]} is not in the table of modules"
        if room in modules and parts[1] != room and parts[1] not in modules[room]:
            allowed = ", ".join(m for m in modules if m in modules[room]) or "nothing"
            return f"{room} may include {allowed}; {parts[1]} is not among them"
    elif quoted and room in modules and not (is_test and header.startswith("tests/support/")):
        return f'"{header}": write it as "suffuse/module/file.hpp"'
    return None


def check(root):
    modules, libraries = read_table(root / "tools" / "layers.txt")
    complaints, files = [], 0
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
