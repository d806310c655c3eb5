# SPDX-License-Identifier: BSD-3-Clause
"""Functions shared by tests inside ParaView: the plugin, data, sets of simplices, and checks."""

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
    """Loads the plugin given by the environment into this session."""
    simple.LoadPlugin(os.environ["INTERLUME_PLUGIN"], remote=False, ns=vars(simple))


def can_exchange_data():
    """Returns whether processes can exchange data as XML with raw bytes, which VTK before 9.3 cannot read
    with an expat that defers parsing (https://gitlab.kitware.com/vtk/vtk/-/issues/19258)."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    for i in range(10000):  # more than the parser processes at once
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
    """Returns the path of a file written by the programs in Extractions."""
    return os.path.join(os.environ["INTERLUME_EXTRACTION_DATA_DIR"], name)


def data_path(name):
    """Returns the path of a file in Data/."""
    return os.path.join(os.environ["INTERLUME_DATA"], name)


def manifest_arrays():
    """Returns the point array names of each file in the manifest of Data/."""
    with open(data_path("MANIFEST.md"), encoding="utf-8") as manifest:
        rows = [line.split("|") for line in manifest if line.startswith("| `")]
    return {row[1].strip(" `"): row[5].replace("`", "").replace(",", " ").split() for row in rows}


def open_data(name):
    """Returns the wavelet source, or an updated reader of a dataset written by write_numbers.py.

    The dataset is a .vtk file unless the name has an extension.
    """
    if name == "wavelet":
        source = simple.Wavelet()
    else:
        source = simple.OpenDataFile(extractions_path(name if "." in name else name + ".vtk"))
    source.UpdatePipeline()
    return source


def open_file(name):
    """Returns an updated reader of a file in Data/."""
    source = simple.OpenDataFile(data_path(name))
    source.UpdatePipeline()
    return source


def interval_volume(source, array, intervals, criteria=()):
    """Returns the filter for a point array. Intervals are pairs, and criteria are triples of name and
    bounds."""
    volume = simple.IntervalVolume(Input=source)
    volume.Scalars = ["POINTS", array]
    volume.Intervals = [value for pair in intervals for value in pair]
    volume.Criteria = [str(value) for criterion in criteria for value in criterion]
    return volume


def time_varying_volume(source, properties):
    """Returns the filter with the given properties."""
    volume = simple.TimeVaryingIntervalVolume(Input=source)
    set_properties(volume, properties)
    return volume


def temporal_source(name, properties):
    """Returns an updated source of the plugin with the given properties."""
    source = getattr(simple, name)()
    set_properties(source, properties)
    source.UpdatePipeline()
    return source


def set_properties(proxy, values):
    for name, value in values.items():
        setattr(proxy, name, value)


def fetch(proxy, port=0, rank=0):
    """Returns the dataset at an output port on a process."""
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy, rank, idx=port)


@contextlib.contextmanager
def warnings_of(watched, events=("WarningEvent",)):
    """Yields a list of the warnings, or other messages, of a VTK object or of a proxy's filter during the
    block. The messages are not printed."""
    if isinstance(watched, servermanager.Proxy):
        watched = watched.GetClientSideObject()
    messages = []

    def note(_caller, _event, text):
        messages.append(text)

    note.CallDataType = "string0"
    tags = [watched.AddObserver(event, note) for event in events]
    try:
        yield messages
    finally:
        for tag in tags:
            watched.RemoveObserver(tag)


def output_in_place(proxy, port=0):
    """Returns the output in this process without gathering, which would change its structure."""
    proxy.UpdatePipeline()
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def leaves(composite):
    """Yields the datasets of a composite dataset in order."""
    iterator = composite.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def as_set(cells):
    """Returns the simplices in an order that depends only on their coordinates.

    A row has the sorted corners and the orientation: +1 if sorting them was an even permutation, -1 if it was odd,
    and 0 if two corners coincide.
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
    """Collects failed checks. `finish` lists them and ends the script with status 1 if there are any."""

    def __init__(self):
        self.failures = []

    def that(self, condition, what):
        if not condition:
            self.failures.append(what)
            print("failed:", what, flush=True)

    def one_message(self, texts, part, what):
        """Checks that there is exactly one message, and that it contains a part."""
        self.that(len(texts) == 1 and part in texts[0], f"{what}: {texts!r}, expected one with {part!r}")

    def equal(self, value, expected, what):
        self.that(value == expected, f"{what}: {value!r}, expected {expected!r}")

    def close(self, value, expected, tolerance, what):
        error = abs(value - expected)
        bound = tolerance * abs(expected)
        self.that(error <= bound, f"{what}: {value!r}, expected {expected!r} within {bound!r}")

    def finish(self):
        # The end of a long output is what remains of it in reports.
        summary = [*("failed: " + what for what in self.failures), f"checks failed: {len(self.failures)}"]
        print("\n".join(summary), flush=True)
        if self.failures:  # otherwise the script must end normally, so that MPI is finalized
            sys.exit(1)


def run(test):
    """Loads the plugin and runs the test with checks, which end the script on failure."""
    load_plugin()
    checks = Checks()
    test(checks)
    checks.finish()


def read_extractions(name):
    """Returns the list in a JSON file written by the programs in Extractions."""
    with open(extractions_path(name), encoding="utf-8") as file:
        extractions = json.load(file)
    assert len(extractions) > 1, "there must be extractions to reproduce"
    return extractions


def check_documentation(checks, proxy):
    """Checks that a proxy and each of its properties have documentation."""
    name = proxy.SMProxy.GetXMLName()
    documentation = proxy.SMProxy.GetDocumentation()
    checks.that(documentation.GetShortHelp() and documentation.GetLongHelp(), f"{name} has help")
    for label in proxy.ListProperties():
        text = proxy.GetProperty(label).SMProperty.GetDocumentation()
        checks.that(text and text.GetDescription().strip(), f"{name}, {label} has documentation")


def check_menu(checks, group, name):
    """Checks that a source is in the menu Interlume, or a filter in one of its submenus, with its own
    icon."""
    hints = servermanager.ProxyManager().GetPrototypeProxy(group, name).GetHints()
    menu = hints.FindNestedElementByName("ShowInMenu")
    menus = ["Interlume"]
    if group == "filters":
        menus = ["Interlume Intervals", "Interlume Time", "Interlume Flow"]
    checks.that(menu and menu.GetAttribute("category") in menus, f"{name} is in a menu of Interlume")
    icon = menu and menu.GetAttribute("icon") or ""
    checks.that(icon.startswith(":/Interlume/"), f"{name} has an icon: {icon!r}")


def check_inputs(checks, name, accepted):
    """Checks which sources a filter accepts as input; `accepted` has pairs of source and expectation."""
    input_property = servermanager.ProxyManager().GetPrototypeProxy("filters", name).GetProperty("Input")
    for source, expected in accepted:
        source.UpdatePipeline()
        input_property.RemoveAllUncheckedProxies()
        input_property.AddUncheckedInputConnection(source.SMProxy, 0)
        is_accepted = bool(input_property.IsInDomains())
        checks.equal(is_accepted, expected, f"{name} accepts {source.SMProxy.GetXMLName()}")
    input_property.RemoveAllUncheckedProxies()
