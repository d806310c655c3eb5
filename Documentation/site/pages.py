# SPDX-License-Identifier: BSD-3-Clause
"""Writes the generated pages of the website: the gallery, and the classes in C++ and Python.

    pages.py SITE_SOURCE IMAGES

SITE_SOURCE is the copy of the repository for Sphinx, with Doxygen's output in xml. IMAGES has an image for each scene
of the gallery, as interlume-gallery writes it. The package interlume must be importable.
"""

import inspect
import json
import re
import sys
from collections import Counter
from html import escape
from pathlib import Path

from PIL import Image

root, images = map(Path, sys.argv[1:3])
XML_INDEX = root / "xml/index.xml"
xml = {}

GROUPS = {
    "Intervals": "Intervals of a field",
    "SpaceTime": "Intervals over time",
    "Light": "Light and shadow in volumes",
    "Mixed": "Volumes with surfaces",
    "Flow": "Flow",
}
MODULES = ["Intervals", "Tetrahedra", "Light", "Flow", "FlowTexture", "Meshing", "Sources", "Isotables", "Common"]
SCENE = re.compile(
    r'SceneRegistration\s+\w+\(\s*\{\s*"([\w-]+)",\s*"([\d.]+)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+),'
    r'\s*((?:"(?:[^"\\]|\\.)*"\s*)+),\s*\{([^}]*)\}')

# Terms for which the search should find a document first, in addition to its title.
KEYWORDS = {
    "Documentation/guide/choosing": ["isovolume"],
    "Documentation/guide/flow": ["streamlines", "stream surface", "time surface"],
    "Documentation/guide/intervals": ["isovolume", "isosurface", "interval volume", "contour", "clip", "threshold"],
    "Documentation/guide/meshing": ["OpenFOAM polyhedra", "TetGen", "Delaunay"],
    "Documentation/guide/packages": ["PyVista", "pip", "wheel", "find_package"],
    "Documentation/guide/paraview": ["remote server", "MPI"],
    "Documentation/guide/scattering": ["scattering", "clouds", "phase function"],
    "Documentation/guide/scene": ["soft shadows", "area light"],
    "Documentation/guide/shadows": ["volume shadow", "transfer function"],
    "Documentation/guide/sources": ["analytic field", "test data"],
    "Documentation/guide/tetrahedra": ["unstructured volume rendering"],
    "Documentation/guide/time": ["time-varying"],
    "Documentation/measurements": ["benchmark"],
    "Documentation/methods/implicit-flow": ["critical points", "vortex axis", "stiff"],
}


def write(path, text):
    path = root / path
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def literal(text):
    """Returns the value of adjacent C++ string literals."""
    return "".join(json.loads(part) for part in re.findall(r'"(?:[^"\\]|\\.)*"', text))


def contents(pages):
    return ".. toctree::\n   :hidden:\n\n" + "".join(f"   {page}\n" for page in pages) + "\n"


def heading(text, line="="):
    return f"{text}\n{line * len(text)}\n\n"


# Gallery


def read_scenes():
    """Returns the scenes by group: id, figure, title, caption, data files, path of the source."""
    scenes = {group: [] for group in GROUPS}
    for path in sorted((root / "Utilities/Gallery/Scenes").glob("*/*.cxx")):
        text = path.read_text()
        found = SCENE.findall(text)
        if len(found) != text.count("SceneRegistration"):
            sys.exit(f"{path}: cannot read the registration of a scene")
        for name, figure, title, caption, data in found:
            scenes[path.parent.name].append(
                (name, figure, literal(title), literal(caption), re.findall(r'"([^"]+)"', data), path))
    for group in scenes.values():
        group.sort(key=lambda scene: [int(number) for number in scene[1].split(".")])
    return scenes


def find_sources(path):
    """Returns the program of a scene, and the programs in the same directory that it includes."""
    included = re.findall(r'#include "Gallery/(Scenes/\w+/\w+)\.h"', path.read_text())
    paths = [path, *(root / f"Utilities/Gallery/{name}.cxx" for name in included)]
    return [source for source in dict.fromkeys(paths) if source.is_file()]


def find_classes(scene, classes):
    """Returns the public classes that the program of a scene uses."""
    text = "".join(source.read_text() for source in find_sources(scene[-1]))
    return [name for name in dict.fromkeys(re.findall(r'#include "(vtk\w+)\.h"', text)) if name in classes]


def read_manifest():
    """Returns content, source and license of each data file."""
    rows = re.findall(r"^\| `([^`]+)` \| (.*?) \| (.*?) \| (.*?) \|", (root / "Data/MANIFEST.md").read_text(), re.M)
    return {file: row for file, *row in rows}


def shrink(image, width):
    image = image.copy()
    image.thumbnail((width, width))
    return image


def save_images(name):
    """Saves the image of a scene, its thumbnail and its animation. Returns the size, and whether it is animated."""
    folder = root / "extra/gallery/images"
    folder.mkdir(parents=True, exist_ok=True)
    path = images / f"{name}.png"
    if not path.is_file():
        sys.exit(f"{path}: the image of a scene is missing")
    image = Image.open(path).convert("RGB")
    image.save(folder / f"{name}.webp", quality=92)
    shrink(image, 480).save(folder / f"{name}-small.webp", quality=85)
    frames = [shrink(Image.open(frame).convert("RGB"), 960) for frame in sorted((images / name).glob("*.png"))]
    if frames:
        frames[0].save(folder / f"{name}-animated.webp", save_all=True, append_images=frames[1:], duration=80, loop=0)
    return image.size, bool(frames)


def write_scene(scene, manifest, classes):
    name, figure, title, caption, data, path = scene
    (width, height), animated = save_images(name)
    sources = [source.relative_to(root) for source in find_sources(path)]
    page = [
        f"# {title}\n",
        f'<p><a href="images/{name}.webp"><img src="images/{name}.webp" width="{width}" height="{height}"'
        f' alt="{escape(title)}"></a></p>\n',
        caption + "\n",
    ]
    if animated:
        page.append(f'<p><img src="images/{name}-animated.webp" alt="{escape(title)}, animated" loading="lazy"></p>\n')
    page += [
        "| | |\n| --- | --- |",
        f"| Figure of the dissertation | {figure} |",
        f"| Render it | `interlume-gallery --scene {name} --size 1600x1000` |",
        f"| Classes | {', '.join(f'{{doc}}`/api/cpp/{used}`' for used in find_classes(scene, classes))} |",
        f"| Program | {', '.join(f'[{source.name}](../{source})' for source in sources)} |",
    ]
    page += [f"| Data | `{file}`: {manifest[file][0]}. Source: {manifest[file][1]}. License: {manifest[file][2]} |"
             for file in data]
    if not data:
        page.append("| Data | computed by the program |")
    page += ["\n## Program\n", f"```{{literalinclude}} ../{sources[0]}\n:language: c++\n```\n"]
    write(f"gallery/{name}.md", "\n".join(page))


def write_gallery(classes):
    scenes = read_scenes()
    manifest = read_manifest()
    page = ["# Gallery\n", "Each image is a short program. Select an image for its caption, its data, its program and"
            " the command that renders it. Figure numbers refer to C. Zhang's dissertation (The Ohio State"
            " University, 2006).\n"]
    for group, title in GROUPS.items():
        page.append(f'## {title}\n\n<div class="thumbnails">')
        for scene in scenes[group]:
            write_scene(scene, manifest, classes)
            page.append(f'<a href="{scene[0]}.html"><img src="images/{scene[0]}-small.webp" alt="" loading="lazy">'
                        f"{escape(scene[2])}</a>")
        page.append("</div>\n")
    names = "\n".join(scene[0] for group in GROUPS for scene in scenes[group])
    page.append(f"```{{toctree}}\n:hidden:\n\n{names}\n```\n")
    write("gallery/index.md", "\n".join(page))
    return scenes


# Search


def find_words(text):
    """Returns the words of a text without a plural s. scorer.js does the same."""
    return [re.sub("s$", "", word) for word in re.findall(r"[a-z_][a-z0-9_]+", text.lower())]


def count_terms(text, titles):
    """Returns the relative length of a text, and how often it uses each word and each pair of words."""
    words = find_words(text)
    counts = Counter([*words, *map(" ".join, zip(words, words[1:]))])
    return {"titles": [" ".join(find_words(title)) for title in titles], "length": round(len(words) / 1000, 2),
            "counts": {term: count for term, count in counts.items() if count > 1}}


def write_search():
    """Adds keywords to documents, and writes the file that orders the results of a search."""
    documents = {}
    for path in sorted([*root.glob("*.md"), *root.glob("Documentation/**/*.md")]):
        name = path.relative_to(root).with_suffix("").as_posix()
        text = path.read_text()
        title, *sections = re.findall(r"^#+ (.*)", text, re.M) or [""]
        keywords = KEYWORDS.get(name, [])
        documents[name] = count_terms("\n".join([text, *sections]), [title, *keywords])
        if keywords:
            path.write_text(f"---\nmyst:\n  html_meta:\n    keywords: {', '.join(keywords)}\n---\n{text}")
    scorer = (root / "Documentation/site/scorer.js").read_text()
    write("scorer.js", f"const documents = {json.dumps(documents, separators=(',', ':'))};\n{scorer}")


# Classes


def read_classes():
    """Returns the public classes by module: name and brief description. Sets the paths of their XML files."""
    for file, name in re.findall(r'<compound refid="(\w+)" kind="class"><name>(vtk\w+)<', XML_INDEX.read_text()):
        xml[name] = root / f"xml/{file}.xml"
    modules = {}
    for module in MODULES:
        headers = sorted([*root.glob(f"Filters/{module}/vtk*.h"), *root.glob(f"Rendering/{module}/vtk*.h")])
        modules[module] = {path.stem: read_brief(path) for path in headers if path.stem in xml}
    return modules


def read_brief(header):
    brief = re.search(r"@brief\s+(.*?)\s*\n \*\s*(?:\n|/)", header.read_text(), re.S).group(1)
    brief = re.sub(r"\s*\n \*\s*", " ", brief)
    return brief[0].upper() + brief[1:]


def find_uses(classes, scenes):
    """Returns links to the pages that use or explain each class."""
    uses = {name: [] for name in classes}
    for folder in ("guide", "methods"):
        for path in sorted((root / "Documentation" / folder).glob("*.md")):
            if path.stem not in ("README", "properties"):
                for name in set(re.findall(r"\bvtk\w+", path.read_text())) & uses.keys():
                    uses[name].append(f"/Documentation/{folder}/{path.stem}")
    for scene in (scene for group in scenes.values() for scene in group):
        for name in find_classes(scene, classes):
            if len(uses[name]) < 12:
                uses[name].append(f"/gallery/{scene[0]}")
    return uses


def write_cpp(modules, uses):
    page = heading("Classes in C++") + "One page for each public class, from the comments of its header.\n\n"
    for module, classes in modules.items():
        page += heading(module, "-") + f"CMake target ``Interlume::Interlume{module}``.\n\n"
        for name, brief in classes.items():
            page += f":doc:`{name}`\n    {brief}\n\n"
            used = "".join(f"* :doc:`{use}`\n" for use in uses[name])
            write(f"api/cpp/{name}.rst", heading(name)
                  + f"``#include <{name}.h>``, CMake target ``Interlume::Interlume{module}``; "
                  + f":doc:`in Python </api/python/{module}>`\n\n"
                  + f".. doxygenclass:: {name}\n   :members:\n   :undoc-members:\n\n"
                  + (heading("See also", "-") + used if used else ""))
    write("api/cpp/index.rst", page + contents([name for classes in modules.values() for name in classes]))


def first_sentence(text):
    sentence = re.split(r"(?<=[.:]) (?=[A-Z])|\n\n|\n-", re.sub(r"\n(?!\n|-)", " ", text.strip()))[0]
    return re.sub(r"([*`_|\\])", r"\\\1", sentence.rstrip(":"))


def describe_method(name, doc):
    """Returns the directive of a method: its signatures, and the first sentence of its description."""
    signatures = re.findall(rf"^({name}\(.*?)\nC\+\+:", doc, re.M | re.S)
    calls = [re.sub(r"\(self(, )?", "(", re.sub(r"\s+", " ", call)).replace("_arg", "value") for call in signatures]
    text = re.search(r"\nC\+\+:.*?\n\n(.*)", doc, re.S)
    calls = f"\n{' ' * 17}".join(calls or [f"{name}()"])
    return f"   .. py:method:: {calls}\n      :noindex:\n\n      {first_sentence(text.group(1)) if text else ''}\n\n"


def describe_class(name, brief, python_class):
    # Macros that declare deprecated names are empty in Doxygen's input.
    documented = re.findall(r"<name>(\w+)</name>", xml[name].read_text())
    members = {key: value for key, value in vars(python_class).items() if key in documented}
    constants = [f"``{key}``" for key, value in vars(python_class).items()
                 if isinstance(value, int) and key.isupper()]
    base = python_class.__base__.__name__
    page = heading(name, "-") + f".. py:class:: {name}\n\n   {brief}."
    page += f" Base class: ``{base}``. Details: :doc:`/api/cpp/{name}`.\n\n"
    if constants:
        page += f"   Constants: {', '.join(constants)}\n\n"
    return page + "".join(describe_method(key, value.__doc__ or "") for key, value in members.items()
                          if inspect.isroutine(value))


def write_python(modules):
    import interlume

    for module, classes in modules.items():
        page = heading(f"{module} in Python")
        page += f"``from interlume import …``, or from ``interlume.Interlume{module}``.\n\n"
        write(f"api/python/{module}.rst", page + "".join(
            describe_class(name, brief, getattr(interlume, name)) for name, brief in classes.items()
            if hasattr(interlume, name)))
    page = heading("Classes in Python")
    page += re.sub(r":\n\n(    \S)", r"::\n\n\1", interlume.__doc__) + "\n\n"
    page += "".join(f"* :doc:`{module}`: ``{'``, ``'.join(classes)}``\n" for module, classes in modules.items())
    write("api/python/index.rst", page + "\n" + contents(modules))


modules = read_classes()
names = {name for classes in modules.values() for name in classes}
scenes = write_gallery(names)
write_cpp(modules, find_uses(names, scenes))
write_python(modules)
write_search()
