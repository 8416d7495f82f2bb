"""What two builds may differ in: each row with its reason. Words that scripts rely on are not among them."""

import dataclasses
import fnmatch
import re

VALUE = "value"  # what stands there is not compared, but that something of this form stands there is
TEXT = "text"  # the same; --texts compares it
GONE = "gone"  # whether it stands there is not compared either


@dataclasses.dataclass(frozen=True)
class Mask:
    files: str  # patterns of names of files, blanks between
    keys: str  # patterns of the end of a place in the tree, blanks between
    kind: str
    reason: str


MASKS = (
    # ---- times and the machine
    Mask("*", "wall_seconds *_seconds seconds seconds_taken numbers/*seconds*", VALUE, "wall time"),
    Mask("*", "particle_steps_per_second reference_steps_per_second", VALUE, "speed"),
    Mask("bench-*", "steps_per_second contact_steps_per_second ns_per_contact", VALUE, "speed"),
    Mask("bench-*", "bytes_per_grain peak_bytes_per_grain", VALUE, "memory that the system gave"),
    Mask("*", "at finished", VALUE, "when it was"),
    Mask("*.html", "wall_time provenance", VALUE, "a column of the table of stages; the tables of the build, the machine and the calls"),
    Mask("plan*.json", "error", GONE, "of stages that took more than 0.2 s"),
    Mask("*", "@program @commit version commit compiler processor", VALUE, "the build and the machine"),
    Mask("stage.json summary.json *.h5", "key @key", VALUE, "begins with a hash of the keys that cases may have, which a new key changes"),
    Mask("*.h5", "sha256/values", VALUE, "of the whole file, which names version and commit; its columns are compared"),
    Mask("entry.json", "depends_on/0", VALUE, "version, commit and bytes of the program; the other lines are the key"),
    Mask("entry.json cache.json", "bytes folder", VALUE, "the length of version and commit; a hash of them"),
    Mask("SHA256SUMS", "*", VALUE, "the files themselves are compared; most have times"),
    # ---- texts for people
    Mask("*", "warnings flaws case_warnings/*/message case_warnings/*/help", TEXT, "sentences; how many is compared"),
    Mask("*", "error/message problems/*/message problems/*/help failures/*/message", TEXT, "sentences"),
    Mask("failed.json", "message", TEXT, "a sentence"),
    Mask("*", "passes/*/verdict", TEXT, "why the procedure stops, a sentence"),
    Mask("events.jsonl", "what", TEXT, "a sentence; the event is compared"),
    Mask("summary.json", "answer/verdict answer/confidence cards/*/detail cards/*/caution", TEXT, "sentences; values are compared"),
    Mask("verify*.json", "damages/*/what", TEXT, "a sentence; the file is compared"),
    Mask("*", "findings/*/claim findings/*/paper findings/*/ours findings/*/why", TEXT, "sentences; id and met are compared"),
    Mask("*", "thresholds/*/from strength/*/remarks", TEXT, "sentences"),
    Mask("*", "stages/*/basis", TEXT, "where the steps come from, in words"),
    Mask("refinement.json new*.json", "*/reason reason left_out", TEXT, "sentences"),
    Mask("new*.json", "stability/given stability/modeled", TEXT, "sentences"),
    Mask("assess*.json", "remarks soils/*/summary criteria/*/remark gradients/*/remark criteria/*/name", TEXT, "sentences"),
    Mask("assessment.json", "summary criteria/*/remark gradients/*/remark", TEXT, "sentences"),
    Mask("explain*.json", "text", TEXT, "a screen for people"),
    Mask("schema.json", "keys/*/text keys/*/value", TEXT, "sentences"),
    Mask("compare*.json", "circumstances", TEXT, "sentences"),
    Mask("*.html", "words", TEXT, "cells of tables without numbers alone"),
    Mask("*.html", "figures/*/caption figures/*/title states/*/label", TEXT, "captions"),
    Mask("*.html *.vl.json", "title description text", TEXT, "captions and titles of axes"),
    Mask("*.csv *.html", "comments/title", TEXT, "a caption"),
    Mask("*.svg", "captions", TEXT, "what the drawing shows, for who cannot see it"),
    Mask("*.svg", "metadata", VALUE, "version, commit, times"),
)

# Files that are left out.
LEFT_OUT = {
    ".lock": "empty",
    "progress.json": "where the run is, in times",
    "prices.txt": "what stages took here, in times",
}

DURATION = re.compile(rb"\d[\d.,]*(-\d[\d.,]*)? (ms|s|min|h|days?)\b")
MESSAGES = ("*.txt",)  # output for people: the times in it are masked


def matches(path, pattern):
    parts = pattern.split("/")
    return len(path) >= len(parts) and all(
        fnmatch.fnmatchcase(str(have), want) for have, want in zip(path[-len(parts):], parts)
    )


def of_file(name, compare_texts, ignored):
    """What `trees.differences` asks: of a place in this file, "gone", "blank" or None."""
    rows = [(pattern, "gone") for pattern in ignored]
    for mask in MASKS:
        if any(fnmatch.fnmatchcase(name, pattern) for pattern in mask.files.split()):
            if mask.kind != TEXT or not compare_texts:
                rows += [(pattern, "gone" if mask.kind == GONE else "blank") for pattern in mask.keys.split()]
    return lambda path: next((kind for pattern, kind in rows if matches(path, pattern)), None)
