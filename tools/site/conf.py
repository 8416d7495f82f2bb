"""How Sphinx makes pages of the Markdown: tools/site.sh."""

import pathlib
import re

project = "suffuse"
author = "The suffuse developers"
copyright = "The suffuse developers; text CC-BY-4.0"
extensions = ["myst_parser"]
myst_heading_anchors = 5
suppress_warnings = ["myst.header"]  # pages may leave out a level, as their authors see them
highlight_language = "none"
html_theme = "alabaster"
html_theme_options = {
    "description": "internal erosion of soils, grain by grain",
    "fixed_sidebar": True,
    "page_width": "1100px",
    "sidebar_width": "260px",
}
html_sidebars = {"**": ["about.html", "searchbox.html", "navigation.html"]}
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False

LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([^)\s#]+)\)")


def lead_to_pages(app, docname, source):
    """A link to a folder leads to the page in it; one to a folder without a page is its words."""
    here = (pathlib.Path(app.srcdir) / docname).parent

    def led(link):
        words, target = link.groups()
        if ":" in target or (here / target).is_file():
            return link[0]
        return f"[{words}]({target}/README.md)" if (here / target / "README.md").is_file() else words

    source[0] = LINK.sub(led, source[0])


def setup(app):
    app.connect("source-read", lead_to_pages)
