"""The public interface changes on purpose, and the version is the same everywhere."""

import importlib.util
import os
import pathlib
import re

import suffuse

ROOT = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"])


def load_tool():
    spec = importlib.util.spec_from_file_location("python_interface", ROOT / "tools/python_interface.py")
    tool = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(tool)
    return tool


def test_the_interface_is_the_one_that_is_kept():
    tool = load_tool()
    found = tool.changes()
    assert not found, "\n".join([tool.ADVICE, *found])


def test_a_changed_signature_would_be_found(monkeypatch):
    tool = load_tool()

    def settle(self, loading, patience=500):
        return None

    monkeypatch.setattr(suffuse.World, "settle", settle)
    assert any(line.startswith("+    settle(self, loading, patience=500)") for line in tool.changes())


def test_the_version_is_one():
    cited = re.search(r"^version: (\S+)$", (ROOT / "CITATION.cff").read_text(), re.M).group(1)
    newest = re.search(r"^## (\S+)", (ROOT / "CHANGELOG.md").read_text(), re.M).group(1)
    assert suffuse.__version__ == cited == newest


def test_the_citation_has_what_journals_require():
    citation = (ROOT / "CITATION.cff").read_text()
    fields = dict(re.findall(r"^([a-z-]+): *(.*)$", citation, re.M))
    assert fields["cff-version"] == "1.2.0"
    for field in ("message", "title", "abstract", "license"):
        assert fields[field], f"CITATION.cff has no {field}"
    assert re.search(r"^authors:\n  - ", citation, re.M) and re.search(r"^keywords:\n  - ", citation, re.M)
    assert not [name for name in fields if name.startswith("repository")]
    released = re.search(r"^## \S+ - (\d{4}-\d\d-\d\d)$", (ROOT / "CHANGELOG.md").read_text(), re.M).group(1)
    assert fields["date-released"] == released
