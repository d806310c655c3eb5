# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx configuration of the website, see Utilities/docs.

The source directory is a copy of the repository, so that relative links work on the website as they do on a code host.
It also contains the generated pages of pages.py, in the directories api and gallery.
"""

import re
import sys
from pathlib import Path

from docutils import nodes
from sphinx import addnodes

here = Path(__file__).resolve().parent
root = here.parent.parent
sys.path.insert(0, str(here))

project = "Interlume"
author = copyright = "the authors of Interlume"
release = re.search(r"project\(Interlume VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text()).group(1)
extensions = ["myst_parser", "breathe", "sphinx.ext.mathjax", "sphinx.ext.graphviz", "flowcharts"]
include_patterns = ["*.md", "Documentation/**", "Data/MANIFEST.md", "api/**", "gallery/**"]
exclude_patterns = ["Documentation/site/**", "**/*.in.md"]
suppress_warnings = ["myst.header"]

# Anchors of headings are those of code hosts.
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False

# Doxygen's output.
breathe_projects = {"Interlume": str(root / "xml")}
breathe_default_project = "Interlume"

# Debian's MathJax 2, see Utilities/docs. Its SVG output needs no fonts. Browsers do not load fonts
# from a folder.
mathjax_path = "mathjax/MathJax.js"
mathjax2_config = {
    "jax": ["input/TeX", "output/SVG"],
    "extensions": ["tex2jax.js", "TeX/AMSmath.js", "TeX/AMSsymbols.js"],
    "showMathMenu": False,
    "messageStyle": "none",
}

graphviz_output_format = "svg"
html_theme = "furo"
html_title = f"Interlume {release}"
html_static_path = [str(here / "static"), str(root / "static")]
html_extra_path = [str(root / "extra")]
html_css_files = ["site.css"]
html_search_scorer = str(root / "scorer.js")
html_copy_source = False
html_use_index = False
toc_object_entries = False
html_show_sphinx = False


def add_contents(app, docname, source):
    """Adds a table of contents to the README of a directory: linked pages in their order, then all others."""
    path = root / f"{docname}.md"
    if path.name == "README.md" and path.parent != root:
        linked = re.findall(r"\]\(([\w-]+)\.md[)#]", source[0])
        pages = dict.fromkeys([*linked, *sorted(page.stem for page in path.parent.glob("*.md"))])
        pages.pop("README", None)
        source[0] += "\n\n```{toctree}\n:hidden:\n\n" + "\n".join(pages) + "\n```\n"


def finish_class(app, doctree):
    """Links the documents that the comments of a header name. Removes the titles of groups without a name."""
    if not app.env.docname.startswith("api/"):
        return
    for title in list(doctree.findall(nodes.rubric)):
        if title.astext().lower() == "unnamed group":
            title.parent.remove(title)
    for text in list(doctree.findall(nodes.Text)):
        parts = re.split(r"(Documentation/[\w/-]+)\.md", text.astext())
        if len(parts) > 1:
            text.parent.replace(text, [link_to(part, app.env) if i % 2 else nodes.Text(part)
                                       for i, part in enumerate(parts)])


def link_to(document, env):
    return addnodes.pending_xref("", nodes.inline(), refdomain="std", reftype="doc", reftarget="/" + document,
                                 refexplicit=False, refwarn=True, refdoc=env.docname)


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("doctree-read", finish_class)
