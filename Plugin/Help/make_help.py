# SPDX-License-Identifier: BSD-3-Clause
"""make_help.py PAGES GUIDE PICTURES: completes the help pages that ParaView generates from the plugin's XML.

Adds the guide to the directory PAGES as guide.html, with its figures. Adds to each filter's page a link to
the guide and, if PICTURES has a file named after the filter, a figure. The script may be run repeatedly.
"""

import html
import os
import re
import shutil
import sys

BEGIN, END = "<!-- Interlume -->", "<!-- /Interlume -->"
TITLE = "Interlume in ParaView in ten minutes"


def inline(text):
    """Converts inline Markdown (code, bold, emphasis, images, links) to HTML. Images are next to the page."""
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]+)`", r"<code>\1</code>", text)
    text = re.sub(r"!\[([^\]]*)\]\((?:[^)]*/)?([^)/]+)\)", r'<img alt="\1" width="720" src="\2"/>', text)
    text = re.sub(r"\[([^\]]+)\]\((https?:[^)]+)\)", r'<a href="\2">\1</a>', text)
    text = re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", text)
    text = re.sub(r"\*\*([^*]+)\*\*", r"<b>\1</b>", text)
    return re.sub(r"\*([^*]+)\*", r"<em>\1</em>", text)


def block(lines):
    """Converts a Markdown paragraph, heading, list or code block to HTML."""
    heading = re.match(r"(#+) (.*)", lines[0])
    if heading:
        level = len(heading[1])
        return f"<h{level}>{inline(heading[2])}</h{level}>"
    if lines[0].startswith("```"):
        return "<pre>" + html.escape("\n".join(lines[1:-1])) + "</pre>"
    kind = {"-": "ul", "1": "ol"}.get(lines[0][0]) if re.match(r"(-|1\.) ", lines[0]) else None
    if kind:
        items = re.split(r"\n(?:-|\d+\.) ", "\n" + "\n".join(lines))[1:]
        return f"<{kind}>" + "".join(f"<li>{inline(item)}</li>" for item in items) + f"</{kind}>"
    return "<p>" + inline("\n".join(lines)) + "</p>"


def page(markdown):
    """Converts a Markdown document to an HTML page."""
    blocks = re.findall(r"```.*?\n```|(?:(?!```)[^\n]+\n?)+", markdown, re.S)
    body = "\n".join(block(text.strip("\n").split("\n")) for text in blocks)
    return f"<html><head><title>{TITLE}</title></head><body>\n{body}\n</body></html>\n"


def complete(path, pictures):
    """Inserts the figure and the link below the heading of a filter's page."""
    with open(path, encoding="utf-8") as file:
        text = re.sub(f"{BEGIN}.*?{END}", "", file.read(), flags=re.S)
    name = os.path.basename(path).split(".")[1]
    added = ""
    if os.path.exists(os.path.join(pictures, name + ".png")):
        added = f'<p><img alt="{name}" width="720" src="{name}.png"/></p>'
    added += f'<p><a href="guide.html">{TITLE}</a></p>'
    text = text.replace("</h2>", f"</h2>{BEGIN}{added}{END}", 1)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def main():
    pages, guide, pictures = sys.argv[1:]
    for name in sorted(os.listdir(pages)):
        if re.fullmatch(r"(filters|sources)\.\w+\.html", name):
            complete(os.path.join(pages, name), pictures)
    with open(guide, encoding="utf-8") as file:
        text = page(file.read())
    with open(os.path.join(pages, "guide.html"), "w", encoding="utf-8") as file:
        file.write(text)
    for name in os.listdir(pictures):
        shutil.copyfile(os.path.join(pictures, name), os.path.join(pages, name))
    # The guide also shows pictures of the parent directory.
    for name in re.findall(r'src="([^"]+)"', text):
        if not os.path.exists(os.path.join(pages, name)):
            shutil.copyfile(os.path.join(os.path.dirname(pictures), name), os.path.join(pages, name))


if __name__ == "__main__":
    main()
