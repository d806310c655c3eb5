# SPDX-License-Identifier: BSD-3-Clause
"""First steps of a new user: files and filters with default settings.

A use has a name and the gestures that lead to an image. A session is a list of uses in one client, each starting
with an empty pipeline. A gesture is an event of ParaView's test player: widget, command, argument.
"""

import os

from plugin_testing import data_path, manifest_arrays

MENU_BAR = "pqClientMainWindow/menubar"
SCANS = ("bonsai.vti", "brainsmall.vti", "headsq_quarter.vti", "tooth.vti")
COMPUTED_IMAGES = ("hydrogen_orbital.vti", "ironProt.vtk", "isabel_pressure_sub100.vti", "neghip.vti")
APPLY = ("pqClientMainWindow/propertiesDock/propertiesPanel/Accept", "activate", "")


def opened(name):
    """Opens a file in the File menu and applies it."""
    return [
        (MENU_BAR + "/menu_File", "activate", "actionFileOpen"),
        ("pqClientMainWindow/FileOpenDialog", "filesSelected", os.path.realpath(data_path(name))),
        APPLY,
    ]


def applied(*filters):
    """Applies each filter from the alphabetical list in the Filters menu."""
    menu = MENU_BAR + "/menuFilters/Alphabetical"
    return [gesture for name in filters for gesture in ((menu, "activate", name), APPLY)]


def drawn_as(representation):
    """Selects a representation in the toolbar."""
    chooser = "pqClientMainWindow/representationToolbar/displayRepresentation/comboBox"
    return [(chooser, "activated", representation)]


def stem(name):
    return os.path.splitext(name)[0]


def sliced(name):
    return opened(name) + drawn_as("Shadowed Slices")


def sessions():
    """Returns the uses of each session by name; a use is a list of gestures."""
    return {
        "Open": {f"open-{stem(name)}": opened(name) for name in manifest_arrays()},
        "Scans": {f"slices-{stem(name)}": sliced(name) for name in SCANS},
        "Images": {f"slices-{stem(name)}": sliced(name) for name in COMPUTED_IMAGES},
        "Intervals": {
            f"intervals-{stem(name)}": opened(name) + applied("IntervalVolume")
            for name in ("disk_out_ref.vtu", "mug.ex2", "neghip.vti")
        },
        "Time": {"time-mug": opened("mug.ex2") + applied("TimeVaryingIntervalVolume")},
        "Contours": {
            f"contour-{stem(name)}": opened(name) + applied("IsotableContour")
            for name in ("disk_out_ref.vtu", "tooth.vti")
        },
        "Flow": {
            f"flow-{stem(name)}": opened(name)
            + applied("ImplicitFlowField", "InflowMapping", "FlowVolume")
            for name in ("disk_out_ref.vtu", "post.vts")
        },
        "Meshing": {"meshing-disk": opened("disk_out_ref.vtu") + applied("TetrahedralMesher")},
    }
