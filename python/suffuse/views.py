"""What notebooks show of worlds, plans, runs and tables: self-contained HTML that loads nothing."""

import html
import pathlib

import numpy

from suffuse import _core
from suffuse.records import Records

# Where tools/bootstrap.sh lets npm put the report's page, seen from build/release/python/suffuse, and where an
# installation has it.
_HERE = pathlib.Path(__file__).resolve()
_PAGES = (_HERE.parents[3] / "report-page", _HERE.parents[3].parent / "share/suffuse/report-page")


def page_folder():
    """The built page of the report, or an empty path: pages are then plain."""
    return next((page for page in _PAGES if page.is_dir()), pathlib.Path())


def _cell(value):
    if isinstance(value, (float, numpy.floating)):
        return "" if numpy.isnan(value) else f"{value:.5g}"
    return html.escape(f"{value:,}" if isinstance(value, int) and not isinstance(value, bool) else str(value))


def _aligned(text):
    """Numbers and ranges are right-aligned, so that their digits line up."""
    is_number = all(character.isdigit() or character in " .,+-e" for character in text.replace("to", ""))
    return f'<td style="text-align:{"right" if is_number else "left"}">{text}</td>'


def table(head, rows):
    """An HTML table of a heading and rows of values."""
    lines = ["".join(f"<th>{html.escape(name)}</th>" for name in head)] if head else []
    lines += ["".join(_aligned(_cell(value)) for value in row) for row in rows]
    return "<table>" + "".join(f"<tr>{line}</tr>" for line in lines) + "</table>"


class View:
    """Grains in 3D, to be turned and colored: shown by notebooks, kept by save(). A page that stands by itself, 1.5 MB and
    10 to 30 bytes a grain; still pictures where the report's page was not built."""

    def __init__(self, page):
        self.page = page

    def save(self, path):
        """Writes the page as an HTML file."""
        pathlib.Path(path).write_text(self.page, encoding="utf-8")
        return pathlib.Path(path)

    def _repr_html_(self):
        return f'<iframe srcdoc="{html.escape(self.page)}" style="width:100%;height:640px;border:0"></iframe>'

    def __repr__(self):
        return f"<suffuse.View: {len(self.page)} bytes of HTML; save() keeps it>"


def _view(world, title="grains"):
    """The grains in 3D, for a notebook: a View. view().save("grains.html") keeps it for a browser."""
    return View(_core.scene_page(world, title, page_folder()))


def _show_world(world):
    numbers = world.measure()
    edges = numpy.linalg.norm(world.cell, axis=0) * 1e3
    rows = [
        ("grains", len(world)),
        ("fines", int(world.grains.fine.sum())),
        ("diameters [mm]", f"{2e3 * world.grains.radius.min():.4g} to {2e3 * world.grains.radius.max():.4g}"),
        ("edges of the cell [mm]", " x ".join(f"{edge:.4g}" for edge in edges)),
        *((_core.title(key), _core.in_unit_shown(key, numbers[key])) for key in ("void_ratio", "mean_stress", "deviator_stress")),
        ("contacts", numbers["contacts"]),
        *((_core.title(key), _core.in_unit_shown(key, numbers[key])) for key in ("coordination", "unbalanced_force")),
        ("time [s], steps", f"{world.time:.4g}, {world.step_number:,}"),
    ]
    return "<b>suffuse.World</b>" + table((), rows)


def _show_seepage(water):
    pores = water.network
    rows = [
        *((_core.title(key), _core.in_unit_shown(key, getattr(water, key))) for key in ("gradient", "permeability")),
        ("superficial velocity [m/s]", float(numpy.linalg.norm(water.mean_velocity))),
        ("Reynolds number [-]", water.reynolds_number),
        ("flux left by inertia [-]", water.flux_left_by_inertia),
        (_core.title("tortuosity"), _core.in_unit_shown("tortuosity", water.tortuosity)),
        ("pores, throats", f"{pores.pores:,}, {pores.throats:,}"),
        ("solver", water.solver),
        ("balance of forces, error [-]", water.force_sum_error),
        ("residual of the pressures [-]", water.residual),
    ]
    return "<b>suffuse.Seepage</b>" + table((), rows)


def _show_records(records):
    most = 20
    units = records.units
    head = [f"{name} [{units[name]}]" if units.get(name, "-") != "-" and "[" not in name else name for name in records.dtype.names]
    rest = f"<p>{len(records) - most} more rows</p>" if len(records) > most else ""
    return table(head, [row.tolist() for row in records[:most]]) + rest


def show_plan(plan):
    def between(least_most):
        return " to ".join(f"{value:,.3g}" for value in dict.fromkeys(least_most))

    rows = [
        (f'{one["study"]}/{one["stage"]}', one["verb"], one["grains"], between(one["steps"]), between(one["seconds"]))
        for one in plan["stages"]
    ]
    return f"<pre>{html.escape(plan['text'])}</pre>" + table(("stage", "do", "grains", "steps", "seconds"), rows)


def show_run(run):
    state = ("void_ratio", "mean_stress")
    rows = []
    for name in run.stages:
        numbers = run[name].numbers
        rows.append(
            (name, numbers["verb"], numbers["grains"], *(_core.in_unit_shown(key, numbers[key]) for key in state), numbers["wall_seconds"])
        )
    head = ("stage", "do", "grains", *map(_core.title, state), "wall time [s]")
    head_text = f"<b>suffuse.Run</b> {html.escape(str(run.folder))}"
    if (run.folder / "summary.json").exists():
        summary = run.summary
        cards = [(card["label"], card["value"], card["detail"]) for card in summary["answer"]["cards"]]
        head_text += f"<p><b>{html.escape(summary['title'])}</b>. {html.escape(' '.join(summary['answer']['verdict']))}</p>"
        head_text += table((), cards) if cards else ""
        head_text += "".join(f"<p>&#9888; {html.escape(text)}</p>" for text in summary["flaws"])
    return head_text + table(head, rows)


_core.World._repr_html_ = _show_world
_core.World.view = _view
_core.Seepage._repr_html_ = _show_seepage
Records._repr_html_ = _show_records
