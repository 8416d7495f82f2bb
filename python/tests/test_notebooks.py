"""The cells of each notebook run in their order, and what they show can be shown."""

import ast
import json
import os
import pathlib
import tempfile

import pytest

FOLDER = pathlib.Path(os.environ["SUFFUSE_SOURCE_DIR"]) / "examples" / "notebooks"
BOOKS = sorted(FOLDER.glob("*.ipynb"))


def cells_of(path):
    book = json.loads(path.read_text(encoding="utf-8"))
    return [cell for cell in book["cells"] if cell["cell_type"] == "code"]


def run_cell(source, names):
    """Runs the statements of a cell as a notebook does; returns the value of a last expression."""
    body = ast.parse(source).body
    last = ast.Expression(body.pop().value) if isinstance(body[-1], ast.Expr) else None
    exec(compile(ast.Module(body, []), "cell", "exec"), names)  # noqa: S102, a notebook is a program
    return eval(compile(last, "cell", "eval"), names) if last else None  # noqa: S307


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, monkeypatch, tmp_path):
    monkeypatch.chdir(FOLDER)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    names = {"__name__": "__main__"}
    shown = [run_cell("".join(cell["source"]), names) for cell in cells_of(path)]
    pages = [value._repr_html_() for value in shown if hasattr(value, "_repr_html_")]
    assert pages and all(page.startswith("<") for page in pages)


@pytest.mark.parametrize("path", BOOKS, ids=lambda path: path.stem)
def test_a_notebook_is_kept_without_outputs(path):
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in cells_of(path))


def test_every_notebook_is_listed():
    notebook_page = (FOLDER / "README.md").read_text()
    assert len(BOOKS) == 3 and all(path.name in notebook_page for path in BOOKS)
