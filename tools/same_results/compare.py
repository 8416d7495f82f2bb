"""Compares what two builds left in the folders of one job."""

import fnmatch
import json
import re

import files
import masks
from trees import ABSENT, Difference, differences

CACHED = re.compile(r"^(.*/)?([0-9a-f]{16})/")  # folders of cache entries are named by a hash of program and key


def listed(folder):
    """Files by the name that both sides have for them. Of a cache entry its key alone is read: the other files, None
    here, are those of the stage."""
    found, entries = {}, {}
    for path in sorted(folder.rglob("*")):
        name = str(path.relative_to(folder))
        if not path.is_file() or path.suffix == ".err" or path.name in masks.LEFT_OUT:
            continue
        entry = CACHED.match(name)
        if entry and (path.parent / "entry.json").exists():
            if path.parent not in entries:
                entries[path.parent] = f"{entry[1] or ''}{json.loads((path.parent / 'entry.json').read_text())['made_as']}"
            name = f"{entries[path.parent]}/{path.name}"
        while name in found:  # two entries of one stage, as of a sweep
            name += "'"
        found[name] = None if entry and path.name != "entry.json" else path
    return found


def content(path, side):
    """The bytes of a file without what shows which side wrote it."""
    data = path.read_bytes()
    if path.suffix in (".h5", ".png"):
        return data
    data = data.replace(str(side).encode(), b"FOLDER")
    if any(fnmatch.fnmatchcase(path.name, pattern) for pattern in masks.MESSAGES):
        data = masks.DURATION.sub(b"TIME", data)
    return data


def tree_of(path, data):
    tree = files.read(path, data)
    if path.name == "entry.json":
        tree["depends_on"] = tree["depends_on"].splitlines()
    return tree


def compare_files(pair, sides, options):
    """Differences of two files. What cannot be read is one, not a reason to pass it over."""
    if pair == (None, None):
        return []
    data = [content(path, side) for path, side in zip(pair, sides)]
    if data[0] == data[1]:
        return []
    try:
        trees = [tree_of(path, bytes_of) for path, bytes_of in zip(pair, data)]
    except (ValueError, KeyError, TypeError, IndexError, AttributeError) as error:
        return [Difference((), "bytes", f"other bytes, which cannot be read: {error!r}")]
    rows = masks.of_file(pair[0].name, options.texts, options.ignore)
    return differences(*trees, rows)


def written(there, file):
    path = there[0].get(file) or there[1].get(file)
    return (path.stat().st_mtime_ns if path else 0, file)


def compare_job(name, before, after, options):
    """How many files were compared, and those that differ: name -> differences. The file that was written first comes
    first, for what is wrong in a stage makes others wrong after it."""
    there = [listed(side / name) for side in (before, after)]
    found = {}
    for file in sorted({*there[0], *there[1]}, key=lambda file: written(there, file)):
        if file not in there[0] or file not in there[1]:
            found[file] = [Difference((), *("a file" if file in side else ABSENT for side in there))]
            continue
        wrong = compare_files((there[0][file], there[1][file]), (before, after), options)
        if wrong:
            found[file] = wrong
    return len({*there[0], *there[1]}), found
