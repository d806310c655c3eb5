# SPDX-License-Identifier: BSD-3-Clause
"""The tables and numbers of the pages: which rows of a suite, and which of their numbers.

A table has a line for each value of the fields `by` among the rows `where`. Columns are a heading and a template of
cells.py, with the fields of the column's rows if those differ from `where`. `names` gives words for values.
"""

DATA = {"wavelet-97": "wavelet, 97³ points, image data", "head-ct": "CT head, image data",
        "isabel": "hurricane pressure, image data", "blunt-fin": "blunt fin, curvilinear",
        "disk-out": "disk, 7,472 unstructured hexahedra"}
SIZES = {"gyroid-0.3M": "0.3 M", "gyroid-2M": "2 M", "gyroid-8M": "8 M"}
ONE = {"parameter": "1 thread"}
TWO = {"parameter": "2 threads"}
INTERVAL = {"method": "interval-volume", **ONE}
SECOND = {"method": "threads-2"}
HEXAHEDRA = {"method": "isotable-hexahedra", "peer": "contour3dlinear-merge", **ONE}
WARM = {"method": "warm", **ONE}
TIME = "{seconds}"
FITTED = "{exponent:2} ({least:2}–{most:2})"


def table(suite, head, by, columns, names=None, **where):
    return {"suite": suite, "head": head, "by": by.split(), "columns": columns, "names": names or {}, "where": where}


def shadowed(number):
    return {"method": "shadows", "peer": "shadows-off", "parameter": number}


def equal_error(integrator):
    return {"method": "equal-error", "peer": f"streamtracer-{integrator}"}


TABLES = {
    "tables": table(
        "tables", "interval table", "case",
        [("entries", "{entries}"), ("simplices: mean, most", "{mean:4}, {max}"),
         ("in the source's order", "{mean:4}, {max}", {"method": "source-order"})],
        {"tetrahedron-time": "tetrahedron × time", "hexahedron-time": "hexahedron × time"},
        case=("tetrahedron", "hexahedron", "tetrahedron-time", "hexahedron-time"), method="shipped"),
    "interval": table(
        "interval", "data", "case",
        [("tetrahedra", "{tetrahedra}"), ("against two clips", "{ratio}"),
         ("and into tetrahedra", "{ratio}", {"peer": "clip2-tetrahedra", **INTERVAL}),
         ("a second thread", "{ratio}", SECOND)], peer="clip2", **INTERVAL),
    "contour": table(
        "contour", "data", "case",
        [("points shared", "{ratio}"),
         ("not shared", "{ratio}", {"method": "isotable-hexahedra-unmerged", "peer": "contour3dlinear", **ONE}),
         ("image data", "{ratio}", {"method": "isotable-image", "peer": "flyingedges", **ONE})], **HEXAHEDRA),
    "tetrahedra": table(
        "tetrahedra", "path, order", "method parameter",
        [(words, "{ratio} ({seconds})", {"case": case, "peer": "projectedtetrahedra", "error": None})
         for case, words in SIZES.items()],
        method=("software", "opengl"), peer="projectedtetrahedra", error=None,
        parameter=("composite", "optical depth")),
    "graphics-card": table(
        "graphics-card", "tetrahedra, frame", "method parameter",
        [(words, TIME, {"case": case}) for case, words in SIZES.items()],
        case="gyroid-2M", parameter=(None, "composite")),
    "graphics-card.shadows": table(
        "graphics-card", "volume, frame", "case",
        [("ray caster", TIME, {"method": "gpu"}), ("no shadows", TIME, {"method": "shadows-off"}),
         *((f"{number} lights", TIME, {"method": "shadows", "parameter": number}) for number in (1, 2, 4))],
        method="gpu"),
    "shadows": table(
        "shadows", "data", "case",
        [("one light", TIME), ("over no shadows", "{over_off}"), ("2 lights over 1", "{over_one_light}", shadowed(2)),
         ("4 over 1", "{over_one_light}", shadowed(4)),
         ("ray caster over ours", "{ratio}", {"method": "shadows-off", "peer": "gpu"})], **shadowed(1)),
    "shadows.equal-error": table(
        "shadows", "at the error of our default", "case",
        [("error", "{error:2}"), ("time", TIME), ("`gpu-shadows` over it", "{ratio}")],
        method="equal-error"),
    "scattering": table("scattering", "slab, cells through it", "case parameter",
                        [(mode, "{error:%}", {"method": mode}) for mode in ("single", "forward", "full")],
                        method="full", parameter=(8, 32),
                        error_norm="relative difference of reflection or transmission, the larger one"),
    "scattering.cloud": table("scattering", "cloud", "method",
                              [("error", "{error:2}"), ("time over shadows only", "{slower}")],
                              case="cloud", parameter="default", method=("single", "forward", "full")),
    "soft-shadows": table("soft-shadows", "scene", "case",
                          [("error", "{error:2}"), ("of hard shadows", "{error:2}", {"method": "hard"}),
                           ("time over hard shadows", "{over_hard}"),
                           ("error of the convolution over ours, at equal time", "{convolution_over_default}",
                            {"method": "equal-time"})], method="default"),
    "mixed": table("mixed", "map resolution", "parameter",
                   [("error", "{error:2}"), ("`vtkShadowMapPass`", "{error:2}", {"method": "shadow-maps"}),
                    ("time over its", "{over_peer}"),
                    ("light moves", "{over_peer}", {"method": "scene-pass, light moves"})],
                   method="scene-pass", peer="shadow-maps", parameter=(256, 1024, 4096)),
    "interval4d": table("interval4d", "data", "case",
                        [("4-simplices", "{simplices}"), ("tetrahedra", "{tetrahedra}"), ("warm", TIME),
                         ("cold", TIME, {"method": "cold"}), ("a second thread", "{ratio}", SECOND)], **WARM),
    "flow": table("flow", "field", "case",
                  [(words, "{error:2}, {time_error:2}: {seconds}", {"method": method, "parameter": parameter})
                   for words, method, parameter in (("ours", "automatic", 1e-6), ("RK4, half a cell", "RK4", 0.5),
                                                    ("RK45, `1e-8`", "RK45", 1e-8))],
                  method="automatic", parameter=1e-6, case=("rotation", "saddle", "sphere", "abc")),
    "flow.tubes": table("flow", "method, resolution", "method parameter",
                        [(case, "{error:2}: {seconds}", {"case": case}) for case in ("beside", "around")],
                        case="beside", method=("explicit", "implicit", "implicit-again"),
                        parameter=(32, 96)),
    "flow-speed": table("flow-speed", "field", "case",
                        [("our error", "{error:2}"), ("RK4 over ours", "{ratio}"),
                         ("RK45 over ours", "{ratio}", equal_error("RK45")),
                         ("again: RK4", "{ratio}", {**equal_error("RK4"), "method": "equal-error-again"})],
                        **equal_error("RK4")),
    "flow-sharing": table("flow-sharing", "field", "case",
                          [("interpolated", "{share:%}"), ("faster", "{ratio}"),
                           ("default: interpolated", "{share:%}", {"parameter": 1e-6}),
                           ("faster", "{ratio}", {"parameter": 1e-6})], parameter=1e-3,
                          case=("shear", "rotation", "sphere", "abc", "hurricane")),
    "flow-texture": table("flow-texture", "field", "case",
                          [("filtered", "{ratio}"),
                           ("unfiltered", "{ratio}", {"method": "textures, unfiltered", "peer": "gpu-rgba"}),
                           ("filtered, against four components", "{ratio}", {"method": "textures", "peer": "gpu"})],
                          method="textures", peer="gpu-rgba"),
    "growth": table("growth", "N", "case",
                    [("time", FITTED), ("memory", FITTED, {"method": "memory exponent"})], method="time exponent"),
    "ranks": table("ranks", "work, processes", "case parameter",
                   [("processor time of one", "{processor_seconds}"), ("efficiency", "{efficiency}"),
                    ("memory of one over the whole", "{share}", {"method": "memory"})], method="weak scaling"),
    "scene-costs": table("scene-costs", "feature that is on, medians", "parameter",
                         [("passes", "{on_passes}"), ("buffers", "{on_buffers}"), ("bytes", "{on_bytes}"),
                          ("shader words", "{on_words}"), ("ms", "{on_ms}")],
                         case="all scenes", method="vtkShadowedSliceMapper",
                         parameter=("Shadows", "MultipleScattering")),
}
VORTEX = {"case": "vortex-2", **WARM}
HEXAHEDRON = {"case": "random-hexahedra", "method": "inverted"}
HEAD = {"case": "head-ct", "method": "inverted"}
MAPPING = {"method": "new-mapping", **ONE}
VALUES = {
    "interval.memory": ("interval", "{peak_share}", {"method": "memory"}),
    "interval.second-images": ("interval", "{ratio}", {"case": ("wavelet-97", "wavelet-41", "head-ct", "isabel"),
                                                       **SECOND}),
    "interval.second-fin": ("interval", "{ratio}", {"case": "blunt-fin", **SECOND}),
    "interval.second-disk": ("interval", "{ratio}", {"case": "disk-out", **SECOND}),
    "interval.inverted-tetrahedra": ("interval", "{inverted}", {"case": "random-tetrahedra", "method": "inverted"}),
    "interval.inverted-hexahedra": ("interval", "{share:%}", HEXAHEDRON),
    "interval.inverted-hexahedra-volume": ("interval", "{error:%}", HEXAHEDRON),
    "interval.inverted-head": ("interval", "{inverted}", HEAD),
    "interval.tetrahedra-head": ("interval", "{tetrahedra}", HEAD),
    "interval4d.vortex-simplices": ("interval4d", "{simplices}", VORTEX),
    "interval4d.vortex-tetrahedra": ("interval4d", "{tetrahedra}", VORTEX),
    "interval4d.vortex-warm": ("interval4d", TIME, VORTEX),
    "interval4d.vortex-cold": ("interval4d", TIME, {"case": "vortex-2", "method": "cold"}),
    "flow.mapping-tetrahedra": ("flow", "{tetrahedra}", MAPPING),
    "flow.mapping-time": ("flow", TIME, MAPPING),
    "flow-speed.second": ("flow-speed", "{ratio}", {"method": "threads-2"}),
    "flow-texture.shadows": ("flow-texture", "{slower}", {"case": "rotation", "method": "shadows"}),
    "scattering.views": ("scattering", "{slower}", {"case": "cloud, the view turns", "method": "full"}),
    "mixed.budget": ("mixed", "{over_budget}", {"method": "scene-pass", "peer": "volume + 2 actors"}),
}


def ratios(suite, work, data, peer, rows):
    """A line of the README's table."""
    return {"suite": suite, "work": work, "data": data, "peer": peer, "rows": rows}


CASTER = "`vtkGPUVolumeRayCastMapper`"
FRAME = "CT, 256² x 128{}, 512², llvmpipe, two threads; ours at its defaults, slices half a voxel apart"
UNADJUSTED = "a sample each voxel, no adjustment of distances (not its defaults)"
README_LINES = [
    *(ratios("interval", "tetrahedra between two values", words,
             "`vtkTableBasedClipDataSet` twice (mixed cells) / then tetrahedra by `vtkDataSetTriangleFilter`",
             [{"case": case, "peer": peer, **INTERVAL} for peer in ("clip2", "clip2-tetrahedra")])
      for case, words in DATA.items()),
    ratios("contour", "isosurface of image data", "wavelet", "`vtkFlyingEdges3D`",
           [{"case": "wavelet-97", "method": "isotable-image", "peer": "flyingedges", **ONE}]),
    ratios("contour", "isosurface of unstructured hexahedra", "wavelet",
           "`vtkContour3DLinearGrid`, points not shared / shared",
           [{"case": "wavelet-97", "method": "isotable-hexahedra-unmerged", "peer": "contour3dlinear", **ONE},
            {"case": "wavelet-97", **HEXAHEDRA}]),
    *(ratios("tetrahedra", f"tetrahedra as a volume, {words}",
             " / ".join(SIZES.values()) + " tetrahedra, 512², llvmpipe, two threads", "`vtkProjectedTetrahedraMapper`",
             [{"case": case, "method": path, "parameter": "composite", "peer": "projectedtetrahedra", "error": None}
              for case in SIZES]) for path, words in (("software", "software path"), ("opengl", "OpenGL path"))),
    ratios("shadows", "a volume with one light and no shadows", FRAME.format(" / 256³ / sphere / rings, 128³"),
           f"{CASTER} with Shade, {UNADJUSTED}",
           [{"case": case, "method": "shadows-off", "peer": "gpu"}
            for case in ("bonsai-256x256x128", "bonsai-256x256x256", "sphere-128", "rings-128")]),
    ratios("shadows", "a volume with the shadows of one light", FRAME.format(""),
           f"{CASTER} with Shade, volumetric shadows of full reach, {UNADJUSTED}",
           [{"case": "bonsai-256x256x128", "method": "shadows", "peer": "gpu-shadows"}]),
    ratios("shadows", "a volume of scattered light with the shadows of one light, at equal error",
           "sphere / rings / CT, 128³, 256²; ours at its defaults",
           f"{CASTER} with volumetric shadows of full reach, samples as near as needed",
           [{"case": f"{case}, scattering", "method": "equal-error"}
            for case in ("sphere-128", "rings-128", "bonsai-128x128x128")]),
    *(ratios("flow-speed", "where streamlines end, at equal error", f"ABC flow, {words}, 2048 streamlines",
             "`vtkStreamTracer`, RK4 / RK45", [{"case": case, **equal_error(integrator)}
                                               for integrator in ("RK4", "RK45")])
      for case, words in (("image-64", "image 64³"), ("image-128", "image 128³"),
                          ("hexahedra-64", "64³ points, hexahedra"), ("tetrahedra-64", "64³ points, tetrahedra"))),
]
