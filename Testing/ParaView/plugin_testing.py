# SPDX-License-Identifier: BSD-3-Clause
"""What the tests inside ParaView share: the plugin, the data, sets of simplices, checks."""

import contextlib
import json
import os
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter


def load_plugin():
    """Loads the plugin that the environment names into this session."""
    simple.LoadPlugin(os.environ["INTERLUME_PLUGIN"], remote=False, ns=vars(simple))


def can_exchange_data():
    """Processes exchange data as XML with raw bytes, which VTK before 9.3 cannot read with an expat that
    defers parsing (https://gitlab.kitware.com/vtk/vtk/-/issues/19258)."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    for i in range(10000):  # more than the parser takes at once
        points.InsertNextPoint(0.1 * i, 0.7 * i, 0.3 * i)
    grid.SetPoints(points)
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetInputData(grid)
    writer.WriteToOutputStringOn()
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.Update()
    reader = vtkXMLUnstructuredGridReader()
    reader.ReadFromInputStringOn()
    reader.SetInputString(writer.GetOutputString())
    vtkObject.GlobalWarningDisplayOff()
    reader.Update()
    vtkObject.GlobalWarningDisplayOn()
    return reader.GetOutput().GetNumberOfPoints() == points.GetNumberOfPoints()


def extractions_path(name):
    """A file in the folder that the programs in Extractions wrote."""
    return os.path.join(os.environ["INTERLUME_EXTRACTIONS"], name)


def data_path(name):
    """A file in Data/."""
    return os.path.join(os.environ["INTERLUME_DATA"], name)


def manifest_arrays():
    """The files that the manifest of Data/ lists, each with the names of its point arrays."""
    with open(data_path("MANIFEST.md"), encoding="utf-8") as manifest:
        rows = [line.split("|") for line in manifest if line.startswith("| `")]
    return {row[1].strip(" `"): row[5].replace("`", "").replace(",", " ").split() for row in rows}


def open_data(name):
    """The wavelet source, or a reader of a dataset that write_numbers.py left, with its data read.

    The dataset is a .vtk file unless the name has an extension.
    """
    if name == "wavelet":
        source = simple.Wavelet()
    else:
        source = simple.OpenDataFile(extractions_path(name if "." in name else name + ".vtk"))
    source.UpdatePipeline()
    return source


def open_file(name):
    """A reader of a file in Data/, with its data read."""
    source = simple.OpenDataFile(data_path(name))
    source.UpdatePipeline()
    return source


def interval_volume(source, array, intervals, criteria=()):
    """The filter over a point array; intervals are pairs, criteria triples of name and bounds."""
    volume = simple.IntervalVolume(Input=source)
    volume.Scalars = ["POINTS", array]
    volume.Intervals = [value for pair in intervals for value in pair]
    volume.Criteria = [str(value) for criterion in criteria for value in criterion]
    return volume


def time_varying_volume(source, properties):
    """The filter over a source; properties by name."""
    volume = simple.TimeVaryingIntervalVolume(Input=source)
    set_properties(volume, properties)
    return volume


def temporal_source(name, properties):
    """A source of the plugin, with its data made, whose array filters take; properties by name."""
    source = getattr(simple, name)()
    set_properties(source, properties)
    source.UpdatePipeline()
    return source


def set_properties(proxy, values):
    for name, value in values.items():
        setattr(proxy, name, value)


def fetch(proxy, port=0, rank=0):
    """The dataset that a process has as the output of a port."""
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, rank, idx=port)


@contextlib.contextmanager
def warnings_of(watched, events=("WarningEvent",)):
    """The warnings, or other messages, of a VTK object, or of the filter of a proxy, while the block
    runs: a list of texts. They are not printed."""
    if isinstance(watched, servermanager.Proxy):
        watched = watched.GetClientSideObject()
    said = []

    def note(_caller, _event, text):
        said.append(text)

    note.CallDataType = "string0"
    tags = [watched.AddObserver(event, note) for event in events]
    try:
        yield said
    finally:
        for tag in tags:
            watched.RemoveObserver(tag)


def output_in_place(proxy, port=0):
    """The output as the filter made it: gathering it would change its structure."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def leaves(composite):
    """The datasets of a composite dataset, in order."""
    iterator = composite.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def as_set(cells):
    """The simplices in an order that depends on their coordinates alone.

    A row is the corners, sorted, and the orientation: whether sorting them was an even (+1) or an
    odd (-1) permutation, and 0 where two corners coincide.
    """
    count, corners, axes = cells.shape
    cells = cells + 0.0  # no negative zero
    keys = [numpy.ascontiguousarray(cells[:, :, axis]) for axis in reversed(range(axes))]
    order = numpy.lexsort(keys, axis=1)
    ordered = numpy.take_along_axis(cells, order[:, :, None], axis=1)
    parity = numpy.ones(count)
    for first in range(corners):
        for second in range(first + 1, corners):
            parity *= numpy.where(order[:, first] > order[:, second], -1, 1)
    parity[(ordered[:, 1:] == ordered[:, :-1]).all(axis=2).any(axis=1)] = 0
    rows = numpy.concatenate([ordered.reshape(count, -1), parity[:, None]], axis=1)
    return rows[numpy.lexsort(rows.T[::-1])]


class Checks:
    """Counts failed checks; `finish` ends the script with status 1 if there are some."""

    def __init__(self):
        self.failures = 0

    def that(self, condition, what):
        if not condition:
            self.failures += 1
            print("failed:", what, flush=True)

    def said(self, texts, part, what):
        """One message was given, and it has a part."""
        self.that(len(texts) == 1 and part in texts[0], f"{what}: {texts!r}, expected one with {part!r}")

    def equal(self, value, expected, what):
        self.that(value == expected, f"{what}: {value!r}, expected {expected!r}")

    def close(self, value, expected, tolerance, what):
        error = abs(value - expected)
        bound = tolerance * abs(expected)
        self.that(error <= bound, f"{what}: {value!r}, expected {expected!r} within {bound!r}")

    def finish(self):
        print("checks failed:", self.failures, flush=True)
        if self.failures:  # else the script must end by itself, for MPI to be finalized
            sys.exit(1)


def run(test):
    """Loads the plugin and calls the test with checks, which end the script if some fail."""
    load_plugin()
    checks = Checks()
    test(checks)
    checks.finish()


def read_extractions(name):
    """The list of a JSON file in the folder that the programs in Extractions wrote."""
    with open(extractions_path(name), encoding="utf-8") as file:
        extractions = json.load(file)
    assert len(extractions) > 1, "there are extractions to repeat"
    return extractions


def check_documentation(checks, proxy):
    """A proxy and each of its properties say what they are for."""
    name = proxy.SMProxy.GetXMLName()
    documentation = proxy.SMProxy.GetDocumentation()
    checks.that(documentation.GetShortHelp() and documentation.GetLongHelp(), f"{name} has help")
    for label in proxy.ListProperties():
        text = proxy.GetProperty(label).SMProperty.GetDocumentation()
        checks.that(text and text.GetDescription().strip(), f"{name}, {label} has a documentation")


def check_menu(checks, group, name):
    """A source is in the menu Interlume, a filter in one of its menus, each with an icon of its own."""
    hints = servermanager.ProxyManager().GetPrototypeProxy(group, name).GetHints()
    menu = hints.FindNestedElementByName("ShowInMenu")
    menus = ["Interlume"]
    if group == "filters":
        menus = ["Interlume Intervals", "Interlume Time", "Interlume Flow"]
    checks.that(menu and menu.GetAttribute("category") in menus, f"{name} is in a menu of Interlume")
    icon = menu and menu.GetAttribute("icon") or ""
    checks.that(icon.startswith(":/Interlume/"), f"{name} has an icon: {icon!r}")


def check_inputs(checks, name, accepted):
    """The filter of a name takes a source as its input, or does not: pairs of both."""
    input_property = servermanager.ProxyManager().GetPrototypeProxy("filters", name).GetProperty("Input")
    for source, expected in accepted:
        source.UpdatePipeline()
        input_property.RemoveAllUncheckedProxies()
        input_property.AddUncheckedInputConnection(source.SMProxy, 0)
        taken = bool(input_property.IsInDomains())
        checks.equal(taken, expected, f"{name} takes {source.SMProxy.GetXMLName()}")
    input_property.RemoveAllUncheckedProxies()
