"""Documents, comments, messages and names read well: tools/prose.py finds long sentences, and odd words and names."""

import importlib
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"])


@pytest.fixture(scope="module")
def prose():
    sys.path.insert(0, str(ROOT / "tools"))
    yield importlib.import_module("prose")
    sys.path.pop(0)


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="only a clone knows which files are tracked")
def test_the_tree_has_no_long_sentence_and_no_listed_word():
    done = subprocess.run([sys.executable, ROOT / "tools" / "prose.py"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_long_sentence_is_found_and_code_counts_as_one_word(prose):
    most = "word " * 24 + "`code of five words here`"
    longer = f"One {most}"
    assert not list(prose.findings("page.md", f"{most}. {most}; [{most}](a b c): {most}.\n\n| {longer} |\n\n    {longer}\n"))
    text = f"# Title\n\nShort.\n{longer}.\n\n* {most}\n* {most}\n  and more.\n\n```\n{longer}\n```\n"
    assert [(line, kind) for line, kind, _ in prose.findings("page.md", text)] == [(4, "long"), (7, "long")]


def test_a_listed_word_is_found_in_documents_comments_and_strings(prose):
    def lines(name, text):
        return [line for line, kind, _ in prose.findings(name, text) if kind == "word"]

    assert lines("page.md", "One.\nThe user is\ntold, `is told`.\n") == [2]
    assert lines("page.md", "It hangs on\nwhat stands beside it, `beside`.\n") == [1, 2]
    source = 'int n; // heeds\nauto text = "whoever"; /* it is told */\n// They are told apart as is\n// told.\nint beside_it;\n'
    assert lines("file.cpp", source) == [1, 2, 2, 3]
    assert lines("file.cpp", 'warn("the strain "\n     "asked "\n     "for is reached, as asked");\n') == [2, 3]
    assert lines("file.py", '"""Reckons."""\nhelp = "the asked size"  # hardly\n') == [1, 2, 2]
    assert lines("script.sh", "echo 'as asked' # as asked\n") == [1]
    assert not lines("suffuse/record/earlier_endings.cpp", '"# % was asked for"\n')


def test_an_odd_name_is_found_in_sources_but_not_in_strings_and_not_where_it_is_a_key(prose):
    source = 'int most_told; // told\nauto key = "asked", text = R"(heed\nwish)"; stream.tellg();\nvoid tellPlan(Stranger beside2);\n'
    assert [finding for finding in prose.findings("file.cpp", source) if finding[1] == "name"] == [
        (1, "name", "most_told"), (4, "name", "tellPlan"), (4, "name", "Stranger"), (4, "name", "beside2")]
    assert [line for line, kind, _ in prose.findings("file.mjs", "show(`asked ${value}`);\nconst asked = 'told';\n") if kind == "name"] == [2]
    assert not list(prose.findings("file.py", "world.mobility(asked_gradient=0.2)  # besides, a mask\nmasked = basket\n"))
    assert [kind for _, kind, _ in prose.findings("measure_asked.hpp", "")] == ["name"]
