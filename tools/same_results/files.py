"""Reads each kind of file that the program writes as a tree (trees.py)."""

import base64
import csv
import html.parser
import io
import json
import re
import struct
import zlib

import cbor
import hdf5
from trees import Array, Literal

VTK_LETTERS = {"Float32": "f", "Float64": "d", "Int64": "q", "UInt32": "I", "UInt8": "B"}
WALL_TIME = "time [s]"  # heads the column of a report's stages that differs from run to run
SUMMARIES = ("provenance", "calls")  # tables of who ran what and when
PACKED = ("report-data", "scene-data")  # elements of the page that hold the data of its script


def of_json(text):
    return json.loads(text, parse_float=Literal, parse_int=Literal, parse_constant=Literal)


def of_csv(text):
    """Comments `# key: value` by key, cells by column; a column without a name has its number."""
    comments, lines = {}, text.splitlines()
    while lines and lines[0].startswith("#"):
        key, _, value = lines.pop(0)[1:].strip().partition(": ")
        comments[key] = value
    rows = list(csv.reader(io.StringIO("\n".join(lines)), strict=True))
    names = rows[0] if rows else []
    widths = [str(len(row)) for row in rows[1:] if len(row) != len(names)]
    columns = {name: [Literal(row[k]) for row in rows[1:] if k < len(row)] for k, name in enumerate(names)}
    return {"comments": comments, "columns": columns, "names": names, "rows of another width": widths}


class Page(html.parser.HTMLParser):
    """The data of a report: what is packed for its script, the cells of its tables, and what can be linked to."""

    def __init__(self):
        super().__init__()
        self.tree = {"data": {}, "tables": [], "anchors": [], "links": []}
        self.inside, self.packed = None, None

    def handle_starttag(self, tag, attributes):
        named = dict(attributes)
        if "id" in named:
            self.tree["anchors"].append(named["id"])
        if tag == "a":
            self.tree["links"].append(named.get("href", ""))
        if tag == "script":
            self.packed = named.get("id")
        if tag == "table":
            self.tree["tables"].append({"class": named.get("class", ""), "header": [], "rows": []})
        if tag == "tr" and self.tree["tables"]:
            self.tree["tables"][-1]["rows"].append([])
        if tag in ("td", "th"):
            self.inside = (tag, named.get("class") == "number", [])

    def handle_endtag(self, tag):
        if self.inside and tag == self.inside[0]:
            table, (_, is_number, texts) = self.tree["tables"][-1], self.inside
            cells = table["header"] if tag == "th" else table["rows"][-1]
            is_time = tag == "td" and table["header"][len(cells)].get("number") == WALL_TIME
            kind = "wall_time" if is_time else "number" if is_number else "words"
            cells.append({"provenance" if table["class"] in SUMMARIES else kind: "".join(texts)})
            self.inside = None

    def handle_data(self, data):
        if self.inside:
            self.inside[2].append(data)
        if self.packed in PACKED and data.strip():
            self.tree["data"][self.packed] = of_json(zlib.decompress(base64.b64decode(data)).decode())
            self.packed = None


def of_page(text):
    page = Page()
    page.feed(text)
    for figure in page.tree["data"].get("report-data", {}).get("figures", []):
        figure["csv"] = of_csv(figure["csv"])
    return page.tree


def of_vtk(data):
    """The tags of a ParaView file, and its arrays by the name of the section and their own."""
    head, mark, blocks = data.partition(b'<AppendedData encoding="raw">\n_')
    text, arrays, section = head.decode(), {}, ""
    for line in text.splitlines() if mark else []:
        tag = re.match(r"<(\w+)", line)
        if tag and tag[1] != "DataArray":
            section = tag[1]
        named = dict(re.findall(r'(\w+)="([^"]*)"', line))
        if tag and tag[1] == "DataArray" and "offset" in named:
            at = int(named["offset"])
            (size,) = struct.unpack_from("<Q", blocks, at)
            kind = VTK_LETTERS[named["type"]]
            count = size // struct.calcsize(kind)
            arrays[f"{section}/{named['Name']}"] = Array(kind, (count,), blocks[at + 8:at + 8 + size])
    tail = blocks[-200:].partition(b"\n</AppendedData>")
    return {"tags": text.splitlines(), "arrays": arrays, "end": (tail[1] + tail[2]).decode()}


def of_svg(text):
    tree = {}
    for key, tag in (("metadata", "metadata"), ("captions", "desc")):
        masked = re.compile(f"<{tag}>(.*?)</{tag}>", re.S)
        tree[key], text = masked.findall(text), masked.sub("", text)
    return {**tree, "tags": text.replace("><", ">\n<").splitlines()}


def of_checksums(text):
    return {name: digest for digest, name in (line.split("  ", 1) for line in text.splitlines())}


def of_bytes(data):
    return {"bytes": Array("B", (len(data),), data)}


TEXTS = {
    ".json": of_json,
    ".jsonl": lambda text: [of_json(line) for line in text.splitlines()],
    ".csv": of_csv,
    ".html": of_page,
    ".svg": of_svg,
}


def read(path, data):
    """The tree of a file. @param data of the file, its bytes, in which its folder's name has been replaced"""
    if path.name == "SHA256SUMS":
        return of_checksums(data.decode())
    if path.suffix == ".h5":
        return hdf5.read(path)
    if path.suffix == ".cbor":
        return cbor.decoded(data)
    if path.suffix in (".vtp", ".vtu", ".pvd"):
        return of_vtk(data)
    if path.suffix in TEXTS:
        return TEXTS[path.suffix](data.decode())
    try:
        return data.decode().splitlines()
    except UnicodeDecodeError:
        return of_bytes(data)
