# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx extension: draws Mermaid flowcharts with Graphviz, because Debian has no package of Mermaid."""

import re

from docutils import nodes
from sphinx.ext.graphviz import graphviz

FONT = 'fontname="sans-serif", fontsize=11'
HEAD = ("bgcolor=transparent; ranksep=0.3; nodesep=0.2;"
        ' node [shape=box, margin="0.1,0.05", style="rounded,filled", fillcolor="#eef1f6", color="#8892a6",'
        f' {FONT}]; edge [color="#8892a6", fontcolor="#8892a6", {FONT}]')
NODE = re.compile(r"(\w+)(?:\[([^\]]*)\]|\{([^}]*)\})?\s*")
ARROW = re.compile(r"(?:-->(?:\|([^|]*)\|)?|-- (.*?) -->|-\.->)\s*")


def quoted(text):
    """Returns a label in quotes. Long labels get a line break after each comma and colon."""
    return '"' + re.sub(r"<br>|(?<=[,:]) " if len(text) > 20 else "<br>", r"\\n", text) + '"'


def match(pattern, text, line):
    found = pattern.match(text)
    if not found:
        raise ValueError(f"cannot read this line of a flowchart: {line}")
    return found, text[found.end():]


def to_dot(code):
    """Returns the Graphviz code of a flowchart. Supports the syntax that the documents use."""
    first, *lines = code.strip().splitlines()
    dot = [HEAD, "rankdir=" + first.split()[1].replace("TD", "TB")]
    for line in lines:
        node, rest = match(NODE, line.strip(), line)
        while node:
            name, box, choice = node.groups()
            if box or choice:
                dot.append(f"{name} [label={quoted(box or choice)}{', shape=diamond' if choice else ''}]")
            node = None
            if rest:
                arrow, rest = match(ARROW, rest, line)
                node, rest = match(NODE, rest, line)
                style = "dashed" if arrow.group().startswith("-.") else "solid"
                label = quoted(arrow.group(1) or arrow.group(2) or "")
                dot.append(f"{name} -> {node.group(1)} [label={label}, style={style}]")
    return "digraph {" + ";\n".join(dot) + "}"


def draw(app, doctree):
    for block in list(doctree.findall(nodes.literal_block)):
        if block.get("language") == "mermaid":
            chart = graphviz(code=to_dot(block.astext()), options={})
            block.replace_self(nodes.container("", chart, classes=["flowchart"]))


def setup(app):
    app.connect("doctree-read", draw)
    return {"parallel_read_safe": True}
