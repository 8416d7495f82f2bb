#!/usr/bin/python3
"""Run the commands of a page: run_page.py [--long] PAGE PROGRAM PYTHON_MODULES, from anywhere.

A comment before a block of the page, indented or fenced, says what the block is:

    <!-- file: dyke.csv -->   the content of a file; `<!-- file: dyke.csv, as PATH -->` copies one of the checkout
    <!-- run -->              commands; where lines begin with `$ `, those are the commands and the others what they say
    <!-- run: long -->        commands for ./test --long alone; `<!-- run: adding WORDS -->` adds words to `suffuse run`

All happens in one new folder, in the order of the page, with the checkout's files in sight. A command must end with 0, or with
4: a run that missed a quality bar. What it is said to say must come in that order; `...` stands for any lines, or for any
words in a line. Exit code 1 with the block and what was said where a page is not true.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MARK = re.compile(r"<!-- (file|run)(?:: (.*?))? -->$")
RUN = """#!/bin/sh
case ${1:-} in
*.py) exec python3 "$@" ;;
*.toml) set -- run "$@" ;;
esac
suffuse "$@" || [ $? -eq 4 ]
"""  # what ./run does when all is built
SHELL = "set -e; suffuse() { command suffuse \"$@\" || [ $? -eq 4 ]; }\n"


def blocks(text):
    """Kind, words of the mark, first line and content of each marked block."""
    lines = text.splitlines()
    for number, line in enumerate(lines):
        mark = MARK.match(line)
        if not mark:
            continue
        name, _, origin = (mark[2] or "").partition(", as ")
        if mark[1] == "file" and origin:
            yield "file", name, number + 1, (ROOT / origin).read_text()
            continue
        first = number + 1
        while not lines[first].strip():
            first += 1
        if lines[first].startswith("```"):
            end = lines.index("```", first + 1)
            content = lines[first + 1 : end]
        else:
            end = first
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            content = [line[4:] for line in lines[first:end]]
        yield mark[1], mark[2] or "", first + 1, "\n".join(content).strip("\n") + "\n"


def commands_and_words(content):
    """The commands of a block, joined, and the lines that they are said to say."""
    lines = content.splitlines()
    if not any(line.startswith("$ ") for line in lines):
        return content, []
    commands, printed, is_quoted = [], [], False
    for line in lines:
        if not is_quoted and not line.startswith("$ "):
            printed.append(line)
            continue
        commands.append(line if is_quoted else line[2:])
        is_quoted ^= line.count("'") % 2 == 1
    return "\n".join(commands) + "\n", printed


def missing_line(printed, output):
    """The first line that should have come and did not, or None."""
    rest = [line.rstrip() for line in output.splitlines()]
    for line in printed:
        if line.strip() in ("...", ""):
            continue
        pattern = re.compile(".*".join(re.escape(part) for part in line.rstrip().split("...")))
        while rest and not pattern.fullmatch(rest[0]):
            rest.pop(0)
        if not rest:
            return line
        rest.pop(0)
    return None


def prepare(folder, program, modules):
    """The folder that a reader of the page stands in, and the environment of the commands."""
    for path in ROOT.iterdir():
        if path.name not in ("build", "run", "runs", ".git"):
            (folder / path.name).symlink_to(path)
    tools = folder / ".tools"
    tools.mkdir()
    (tools / "suffuse").symlink_to(program)
    (tools / "python3").write_text(f'#!/bin/sh\nPYTHONPATH="{modules}" exec /usr/bin/python3 "$@"\n')
    (folder / "run").write_text(RUN)
    for script in (tools / "python3", folder / "run"):
        script.chmod(0o755)
    return os.environ | {
        "PATH": f"{tools}:{os.environ['PATH']}", "PYTHONDONTWRITEBYTECODE": "1", "HOME": str(folder),
        "XDG_CACHE_HOME": str(tools / "cache"),
    }


def follow(page, folder, environment, is_long):
    """Complaints about the page: the first one ends it, for what follows stands on it."""
    count = 0
    for kind, words, line, content in blocks(page.read_text()):
        if kind == "file":
            (folder / words).parent.mkdir(parents=True, exist_ok=True)
            (folder / words).write_text(content)
            continue
        if words.startswith("long"):
            if not is_long:
                continue
            words = words.removeprefix("long").strip()
        commands, printed = commands_and_words(content)
        if words:
            added = words.removeprefix("adding ")
            commands = re.sub(r"^(suffuse run .*?|\./run \S+\.toml.*?)( +#.*)?$", rf"\1 {added}", commands, flags=re.M)
        done = subprocess.run(
            ["bash", "-c", SHELL + commands], cwd=folder, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        )
        count += 1
        lacking = missing_line(printed, done.stdout)
        if done.returncode or lacking is not None:
            why = f"ended with {done.returncode}" if done.returncode else f"never said: {lacking}"
            return f"{page.relative_to(ROOT)}:{line}: {why}\n{commands}\n{done.stdout}"
    return None if count else f"{page.relative_to(ROOT)}: nothing to run"


def main():
    is_long = "--long" in sys.argv
    page, program, modules = (pathlib.Path(word).resolve() for word in sys.argv[1:] if word != "--long")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        complaint = follow(page, folder, prepare(folder, program, modules), is_long)
    if complaint:
        sys.exit(complaint)


if __name__ == "__main__":
    main()
