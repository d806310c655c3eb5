# SPDX-License-Identifier: BSD-3-Clause
"""The lines of the README's table: work, data, peer, and the rows whose ratios stand in a line."""

from .data_names import DATA
from .tetrahedra import SIZES

INTERVALS = [{
    "suite": "interval", "work": "tetrahedra between two values", "data": words,
    "peer": "`vtkTableBasedClipDataSet` twice (mixed cells) / then tetrahedra by `vtkDataSetTriangleFilter`",
    "rows": [{"case": case, "method": "interval-volume", "parameter": "1 thread", "peer": peer}
             for peer in ("clip2", "clip2-tetrahedra")]} for case, words in DATA.items()]
CONTOURS = [
    {"suite": "contour", "work": "isosurface of image data", "data": "wavelet", "peer": "`vtkFlyingEdges3D`",
     "rows": [{"case": "wavelet-97", "method": "isotable-image", "parameter": "1 thread", "peer": "flyingedges"}]},
    {"suite": "contour", "work": "isosurface of unstructured hexahedra", "data": "wavelet",
     "peer": "`vtkContour3DLinearGrid`, points not shared / shared",
     "rows": [{"case": "wavelet-97", "method": method, "parameter": "1 thread", "peer": peer}
              for method, peer in (("isotable-hexahedra-unmerged", "contour3dlinear"),
                                   ("isotable-hexahedra", "contour3dlinear-merge"))]}]
TETRAHEDRA = [{
    "suite": "tetrahedra", "work": f"tetrahedra as a volume, {words}",
    "data": " / ".join(SIZES.values()) + " tetrahedra, 512², llvmpipe, two threads",
    "peer": "`vtkProjectedTetrahedraMapper`",
    "rows": [{"case": case, "method": path, "parameter": "composite", "peer": "projectedtetrahedra", "error": None}
             for case in SIZES]} for path, words in (("software", "software path"), ("opengl", "OpenGL path"))]
SHADOWS = [
    {"suite": "shadows", "work": "a volume with one light and no shadows",
     "data": "CT, 256² x 128 / 256³ / sphere / rings, 128³, 512², llvmpipe, two threads; ours at its defaults, slices half a "
             "voxel apart",
     "peer": "`vtkGPUVolumeRayCastMapper` with Shade, a sample each voxel, no adjustment of distances (not its defaults)",
     "rows": [{"case": case, "method": "shadows-off", "peer": "gpu"}
              for case in ("bonsai-256x256x128", "bonsai-256x256x256", "sphere-128", "rings-128")]},
    {"suite": "shadows", "work": "a volume with the shadows of one light",
     "data": "CT, 256² x 128, 512², llvmpipe, two threads; ours at its defaults, slices half a voxel apart",
     "peer": "`vtkGPUVolumeRayCastMapper` with Shade, volumetric shadows of full reach, a sample each voxel, no "
             "adjustment of distances (not its defaults)",
     "rows": [{"case": "bonsai-256x256x128", "method": "shadows", "peer": "gpu-shadows"}]},
    {"suite": "shadows", "work": "a volume of scattered light with the shadows of one light, at equal error",
     "data": "sphere / rings / CT, 128³, 256²; ours at its defaults",
     "peer": "`vtkGPUVolumeRayCastMapper` with volumetric shadows of full reach, samples as near as needed",
     "rows": [{"case": f"{case}, scattering", "method": "equal-error", "error_norm": "channel difference, mean"}
              for case in ("sphere-128", "rings-128", "bonsai-128x128x128")]}]
FLOW = [
    {"suite": "flow-speed", "work": "where streamlines end, at equal error",
     "data": f"ABC flow, {words}, 2048 streamlines", "peer": "`vtkStreamTracer`, RK4 / RK45",
     "rows": [{"case": case, "method": "equal-error", "peer": f"streamtracer-{integrator}"}
              for integrator in ("RK4", "RK45")]}
    for case, words in (("image-64", "image 64³"), ("image-128", "image 128³"), ("hexahedra-64", "64³ points, hexahedra"),
                        ("tetrahedra-64", "64³ points, tetrahedra"))]

README_LINES = [*INTERVALS, *CONTOURS, *TETRAHEDRA, *SHADOWS, *FLOW]
