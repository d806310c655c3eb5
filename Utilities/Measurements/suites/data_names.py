# SPDX-License-Identifier: BSD-3-Clause
"""Words for the data of the suites."""

DATA = {"wavelet-97": "wavelet, 97³ points, image data", "head-ct": "CT head, image data",
        "isabel": "hurricane pressure, image data", "blunt-fin": "blunt fin, curvilinear",
        "disk-out": "disk, 7,472 unstructured hexahedra"}

STEPS = {"vortex-2": "vortex, 2 x 128³", "vortex-3": "vortex, 3 x 128³", "wave-2": "wave, 2 x 40 x 20 x 20",
         "cylinder-2": "cylinder, 2 x 64 x 64 x 32", "delta-2": "delta wing, 2 x 111 x 126 x 51",
         "mug": "mug, 11 x 2,476 unstructured hexahedra"}
