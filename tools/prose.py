#!/usr/bin/python3
"""Find sentences that are hard to read: `tools/prose.py`.

In every tracked Markdown file, a sentence has at most 25 words. Code blocks, tables, headings and HTML do not count, an item
of a list is a text of its own, code in a line is one word, and a link is its words. A sentence ends at one of . ! ? : ; ·
before a blank. Documents, and comments and strings of sources, also do without the words of WORDS; names in sources and
names of sources without those of WORDS_OF_NAMES. Prints each place and how it starts; exit code 1 if there is one.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_WORDS = 25
# "beside" for "compared with" or "next to", "asked" for "specified", "hangs on" for "depends on", "told" for "reported".
WORDS = re.compile(
    r"\b(?:is|are|was|were|be)[\s/#*\"]+told\b(?![\s/#*\"]+apart)|\breckon\w*|\bheed\w*|\bwhoever\b|\bbeside\b|\bhardly\b"
    r"|\bhangs? on\b|\bnext to nothing\b|\bof one's own\b|\basked[\s/#*\"]+for\b|\bas asked\b|\bthe asked\b",
    re.IGNORECASE)
# Of names: words that nobody would search for. A name is requested_plan, mark_leaving, print_results, ForeignFiles.
WORDS_OF_NAMES = {"told", "tell", "tells", "telling", "heed", "heeds", "heeded", "wish", "wishes", "ask", "asks", "asked",
                  "stranger", "strangers", "beside", "reckon", "reckons", "reckoned", "said", "spoken", "hardly"}
KEYS = {"asked_gradient"}  # also names of arguments, in Python
GENERATED = {"docs/case-reference.md", "docs/results.md"}  # by `suffuse schema`, from the tables of the program
OURS = {"tools/prose.py", "python/tests/test_prose.py"}  # name the words, to find them
SAVED = {"suffuse/record/earlier_endings.cpp", "suffuse/record/ending_json.test.cpp"}  # sentences in files of earlier versions

CODE = re.compile(r"(`+).*?\1", re.DOTALL)
LINK = re.compile(r"\[([^\]]*)\]\([^)]*\)")
OTHER = re.compile(r"\||#|<(?:[a-z/!]|$)")  # how a line of a table, a heading or HTML starts
ITEM = re.compile(r"(?:[-*+]|\d{1,2}\.)\s+(?:\[[ x]\]\s+)?")
END = re.compile(r"(?<=[.!?:;·])[)\"'*_]*\s+")

# Comments, and strings, which may hold their signs.
QUOTED = r'"(?:\\.|[^"\\\n])*"' + r"|'(?:\\.|[^'\\\n])*'"
SLASHES = re.compile(rf'R"(\w*)\(.*?\)\1"|{QUOTED}|(?P<lines>(?://[^\n]*\n?\s*)+)|(?P<block>/\*.*?\*/)', re.DOTALL)
HASHES = re.compile(rf'(?P<docstring>"""(?:\\.|[^\\])*?""")|{QUOTED}|(?P<lines>(?<!\S)(?:\#[^\n]*\n?\s*)+)')
COMMENTS = {**dict.fromkeys((".c", ".cpp", ".hpp", ".css", ".js", ".mjs"), SLASHES),
            **dict.fromkeys((".py", ".sh", ".cmake", ".toml", ".txt", ""), HASHES)}

NAMED = {".c", ".cpp", ".hpp", ".js", ".mjs", ".py"}
NAME = re.compile(r"\b[A-Za-z_]\w*")
WORD_OF_NAME = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])")
TEMPLATE = re.compile(r"`(?:\\.|[^`\\])*`", re.DOTALL)


def without_code(text):
    """The text with one word in place of each piece of code."""
    return CODE.sub(lambda code: "code" + "\n" * code.group().count("\n"), text)


def blocks(text):
    """Number of the first line and text of each paragraph and each item of a list; code blocks are left out."""
    start, block, fence, listed, blank = 0, [], False, False, True
    for number, line in enumerate([*text.splitlines(), ""], 1):
        bare = line.strip()
        opens = bare.startswith(("```", "~~~"))
        item = ITEM.match(bare)
        indented = blank and line.startswith("    ") and not listed
        skipped = fence or opens or indented or not bare or OTHER.match(bare)
        if block and (skipped or item):
            yield start, "\n".join(block)
            block = []
        if not skipped:
            start, block = (start, block) if block else (number, [])
            block.append(line[len(line) - len(line.lstrip()) + item.end():] if item else bare.removeprefix("> "))
            listed = bool(item) or (listed and (not blank or line.startswith("  ")))
        fence ^= opens
        blank = not bare or indented or bare.endswith("-->")
    assert not fence, "a code block does not end"


def long_sentences(text):
    """Number of the line and text of each sentence of a Markdown text that has too many words."""
    for start, block in blocks(text):
        plain = LINK.sub(r"\1", without_code(block))
        place = 0
        for end in [*END.finditer(plain), None]:
            sentence = plain[place:end.end() if end else len(plain)]
            if sum(any(c.isalnum() for c in word) for word in sentence.split()) > MOST_WORDS:
                yield start + plain.count("\n", 0, place), sentence
            place = end.end() if end else place


def listed_words(text):
    """Number of the line of each listed word, and the text from there on."""
    for word in WORDS.finditer(text):
        yield text.count("\n", 0, word.start()) + 1, text[word.start():]


def only_words(text, suffix):
    """The comments and strings of a source, each on the line where it stands."""
    lines = [""] * (text.count("\n") + 1)
    for match in COMMENTS[suffix].finditer(text):
        if match.lastgroup or suffix in NAMED:
            first = text.count("\n", 0, match.start())
            for row, line in enumerate(match.group().splitlines()):
                lines[first + row] += " " + line
    return "\n".join(lines)


def odd_names(text, suffix):
    """Number of the line of each name in a source with a word of WORDS_OF_NAMES, and the name; not in strings or comments."""
    code = COMMENTS[suffix].sub(lambda other: " " + "\n" * other.group().count("\n"), text)
    if suffix in (".js", ".mjs"):
        code = TEMPLATE.sub(lambda other: " " + "\n" * other.group().count("\n"), code)
    for name in NAME.finditer(code):
        if name.group() not in KEYS and is_odd(name.group()):
            yield code.count("\n", 0, name.start()) + 1, name.group()


def is_odd(name):
    return any(word.lower() in WORDS_OF_NAMES for word in WORD_OF_NAME.findall(name))


def findings(name, text):
    """What is hard to read in the file of this name: number of the line, what it is, how it starts."""
    suffix = pathlib.Path(name).suffix
    if suffix == ".md":
        if name not in GENERATED:
            yield from ((line, "long", start) for line, start in long_sentences(text))
        yield from ((line, "word", start) for line, start in listed_words(without_code(text)))
    elif suffix in COMMENTS and name not in OURS:
        if name not in SAVED:
            yield from ((line, "word", start) for line, start in listed_words(only_words(text, suffix)))
        if suffix in NAMED:
            yield from ((line, "name", start) for line, start in odd_names(text, suffix))
            yield from ((1, "name", part) for part in [pathlib.Path(name).stem] if is_odd(part))


def main():
    tracked = ["git", "-c", "safe.directory=*", "ls-files"]
    names = subprocess.run(tracked, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    count = 0
    for name in names.splitlines():
        try:
            text = (ROOT / name).read_text()
        except UnicodeDecodeError:
            continue  # no text
        for line, kind, start in sorted(findings(name, text)):
            count += 1
            print(f"{name}:{line}: {kind}: {' '.join(start.split()[:8])} ...")
    return count > 0


if __name__ == "__main__":
    sys.exit(main())
