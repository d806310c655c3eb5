# SPDX-License-Identifier: BSD-3-Clause
"""Tables and numbers of the pages: the rows that they select from a suite, and the fields that they show.

A table has a line for each value of the fields `by` in the rows `where`. A column is a heading, a template of cells.py
and, if they differ from `where`, the fields of its rows. `names` maps values to words.
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


def used(method):
    return {"method": method, "parameter": "on"}


def equal_error(integrator):
    return {"method": "equal-error", "peer": f"streamtracer-{integrator}"}


TABLES = {
    "tables": table(
        "tables", "interval table", "case",
        [("entries", "{entries}"), ("simplices: mean, maximum", "{mean:4}, {max}"),
         ("in the order of the source: mean, maximum", "{mean:4}, {max}", {"method": "source-order"})],
        {"tetrahedron-time": "tetrahedron × time", "hexahedron-time": "hexahedron × time"},
        case=("tetrahedron", "hexahedron", "tetrahedron-time", "hexahedron-time"), method="shipped"),
    "interval": table(
        "interval", "data", "case",
        [("tetrahedra", "{tetrahedra}"), ("ratio to two clips", "{ratio}"),
         ("ratio to two clips and tetrahedra", "{ratio}", {"peer": "clip2-tetrahedra", **INTERVAL}),
         ("speedup by a second thread", "{ratio}", SECOND)], peer="clip2", **INTERVAL),
    "contour": table(
        "contour", "data", "case",
        [("hexahedra, shared points", "{ratio}"),
         ("hexahedra, separate points", "{ratio}",
          {"method": "isotable-hexahedra-unmerged", "peer": "contour3dlinear", **ONE}),
         ("image data", "{ratio}", {"method": "isotable-image", "peer": "flyingedges", **ONE})], **HEXAHEDRA),
    "tetrahedra": table(
        "tetrahedra", "render path, blend mode", "method parameter",
        [(words, "{ratio} ({seconds})", {"case": case, "peer": "projectedtetrahedra", "error": None})
         for case, words in SIZES.items()],
        method=("software", "opengl"), peer="projectedtetrahedra", error=None,
        parameter=("composite", "optical depth")),
    "graphics-card": table(
        "graphics-card", "tetrahedra, time of a frame", "method parameter",
        [(words, TIME, {"case": case}) for case, words in SIZES.items()],
        case="gyroid-2M", parameter=(None, "composite")),
    "graphics-card.shadows": table(
        "graphics-card", "volume, time of a frame", "case",
        [("ray caster", TIME, {"method": "gpu"}), ("no shadows", TIME, {"method": "shadows-off"}),
         *((f"{number} shadowed light{'s' if number > 1 else ''}", TIME, {"method": "shadows", "parameter": number})
           for number in (1, 2, 4))],
        method="gpu"),
    "shadows": table(
        "shadows", "data", "case",
        [("one shadowed light", TIME), ("relative to no shadows", "{over_off}"),
         ("2 lights, relative to 1", "{over_one_light}", shadowed(2)),
         ("4 lights, relative to 1", "{over_one_light}", shadowed(4)),
         ("without shadows: ratio to the ray caster", "{ratio}", {"method": "shadows-off", "peer": "gpu"})],
        **shadowed(1)),
    "shadows.equal-error": table(
        "shadows", "at the error of the default settings", "case",
        [("error", "{error:2}"), ("time", TIME), ("ratio to `gpu-shadows`", "{ratio}")],
        method="equal-error"),
    "scattering": table("scattering", "slab, cells across the slab", "case parameter",
                        [(mode, "{error:%}", {"method": mode}) for mode in ("single", "forward", "full")],
                        method="full", parameter=(8, 32),
                        error_norm="relative difference of reflection or transmission, the larger one"),
    "scattering.cloud": table("scattering", "cloud", "method",
                              [("error", "{error:2}"), ("time relative to shadows only", "{slower}")],
                              case="cloud", parameter="default", method=("single", "forward", "full")),
    "soft-shadows": table("soft-shadows", "scene", "case",
                          [("error", "{error:2}"), ("error of hard shadows", "{error:2}", {"method": "hard"}),
                           ("time relative to hard shadows", "{over_hard}"),
                           ("error of the convolution relative to ours, at equal time", "{convolution_over_default}",
                            {"method": "equal-time"})], method="default"),
    "mixed": table("mixed", "shadow map resolution", "parameter",
                   [("error", "{error:2}"), ("error of `vtkShadowMapPass`", "{error:2}", {"method": "shadow-maps"}),
                    ("time relative to `vtkShadowMapPass`", "{over_peer}"),
                    ("the same, light moves", "{over_peer}", {"method": "scene-pass, light moves"})],
                   method="scene-pass", peer="shadow-maps", parameter=(256, 1024, 4096)),
    "interval4d": table("interval4d", "data", "case",
                        [("4-simplices", "{simplices}"), ("tetrahedra", "{tetrahedra}"), ("warm", TIME),
                         ("cold", TIME, {"method": "cold"}), ("speedup by a second thread", "{ratio}", SECOND)],
                        **WARM),
    "flow": table("flow", "field", "case",
                  [(words, "{error:2}, {time_error:2}: {seconds}", {"method": method, "parameter": parameter})
                   for words, method, parameter in (("Interlume", "automatic", 1e-6), ("RK4, half a cell", "RK4", 0.5),
                                                    ("RK45, `1e-8`", "RK45", 1e-8))],
                  method="automatic", parameter=1e-6, case=("rotation", "saddle", "sphere", "abc")),
    "flow.tubes": table("flow", "method, resolution", "method parameter",
                        [(case, "{error:2}: {seconds}", {"case": case}) for case in ("beside", "around")],
                        case="beside", method=("explicit", "implicit", "implicit-again"),
                        parameter=(32, 96)),
    "flow-speed": table("flow-speed", "field", "case",
                        [("our error", "{error:2}"), ("ratio to RK4", "{ratio}"),
                         ("ratio to RK45", "{ratio}", equal_error("RK45")),
                         ("executed again: ratio to RK4", "{ratio}",
                          {**equal_error("RK4"), "method": "equal-error-again"})],
                        **equal_error("RK4")),
    "flow-sharing": table("flow-sharing", "field", "case",
                          [("interpolated", "{share:%}"), ("speedup", "{ratio}"),
                           ("default tolerance: interpolated", "{share:%}", {"parameter": 1e-6}),
                           ("default tolerance: speedup", "{ratio}", {"parameter": 1e-6})], parameter=1e-3,
                          case=("shear", "rotation", "sphere", "abc", "hurricane")),
    "flow-texture": table("flow-texture", "field", "case",
                          [("filtered", "{ratio}"),
                           ("unfiltered", "{ratio}", {"method": "textures, unfiltered", "peer": "gpu-rgba"}),
                           ("filtered, four independent components", "{ratio}", {"method": "textures", "peer": "gpu"})],
                          method="textures", peer="gpu-rgba"),
    "client": table(
        "client", "use", "case",
        [("first image", "{first_seconds}"), ("complete image", "{still_seconds}"),
         ("rotation: images per second", "{frames/processor_seconds:2}", used("rotate")),
         ("longest wait", "{longest_seconds}", used("rotate")),
         ("slider or handle: images per second", "{frames/processor_seconds:2}", used(("slider", "handle"))),
         ("longest wait", "{longest_seconds}", used(("slider", "handle"))),
         ("panel group collapsed", "{still_seconds}", used("collapse"))], **used("shown")),
    "growth": table("growth", "N", "case",
                    [("time", FITTED), ("memory", FITTED, {"method": "memory exponent"})], method="time exponent"),
    "ranks": table("ranks", "task, processes", "case parameter",
                   [("processor time per process", "{processor_seconds}"), ("efficiency", "{efficiency}"),
                    ("memory per process, relative to one process", "{share}", {"method": "memory"})],
                   method="weak scaling"),
    "scene-costs": table("scene-costs", "enabled feature, medians", "parameter",
                         [("passes", "{on_passes}"), ("buffers", "{on_buffers}"), ("bytes", "{on_bytes}"),
                          ("shader words", "{on_words}"), ("ms", "{on_ms}")],
                         case="all scenes", method="vtkShadowedSliceMapper",
                         parameter=("Shadows", "ScatteringMode")),
}
IMAGES = ("wavelet-97", "wavelet-41", "head-ct", "isabel")
PROJECTED = {"peer": "projectedtetrahedra", "parameter": "composite", "error": None}
VORTEX = {"case": "vortex-2", **WARM}
HEXAHEDRON = {"case": "random-hexahedra", "method": "inverted"}
MAPPING = {"method": "new-mapping", **ONE}
VALUES = {
    "interval.memory": ("interval", "{peak_share}", {"method": "memory"}),
    "interval.second-images": ("interval", "{ratio}", {"case": IMAGES, **SECOND}),
    "interval.inverted-hexahedra": ("interval", "{share:%}", HEXAHEDRON),
    "interval.inverted-hexahedra-volume": ("interval", "{error:%}", HEXAHEDRON),
    "interval4d.vortex-simplices": ("interval4d", "{simplices}", VORTEX),
    "interval4d.vortex-tetrahedra": ("interval4d", "{tetrahedra}", VORTEX),
    "interval4d.vortex-warm": ("interval4d", TIME, VORTEX),
    "interval4d.vortex-cold": ("interval4d", TIME, {"case": "vortex-2", "method": "cold"}),
    "flow.mapping-tetrahedra": ("flow", "{tetrahedra}", MAPPING),
    "flow.mapping-time": ("flow", TIME, MAPPING),
    "flow-speed.second": ("flow-speed", "{ratio}", {"method": "threads-2"}),
    "flow-texture.shadows": ("flow-texture", "{slower}", {"case": "rotation", "method": "shadows"}),
    "scattering.views": ("scattering", "{slower}", {"case": "cloud, the view turns", "method": "full"}),
    "interval.clips-images": ("interval", "{ratio}", {"case": IMAGES, "peer": "clip2", **INTERVAL}),
    "interval.clips-fin": ("interval", "{ratio}", {"case": "blunt-fin", "peer": "clip2", **INTERVAL}),
    "interval.clips-disk": ("interval", "{ratio}", {"case": "disk-out", "peer": "clip2", **INTERVAL}),
    "tetrahedra.software": ("tetrahedra", "{ratio}", {"method": "software", **PROJECTED}),
    "tetrahedra.opengl": ("tetrahedra", "{ratio}", {"method": "opengl", **PROJECTED}),
    "tetrahedra.sorted": ("tetrahedra", TIME, {"case": "gyroid-2M", "method": "software", **PROJECTED}),
    "tetrahedra.unsorted": ("tetrahedra", TIME, {"case": "gyroid-2M", "method": "software", **PROJECTED,
                                                 "parameter": "composite, unsorted"}),
    "tetrahedra.optical-depth": ("tetrahedra", TIME, {"case": "gyroid-2M", "method": "software", **PROJECTED,
                                                      "parameter": "optical depth"}),
    "graphics-card.sorted": ("graphics-card", TIME, {"case": "gyroid-8M", "method": "opengl, vertex shader",
                                                     "parameter": "composite"}),
    "graphics-card.unsorted": ("graphics-card", TIME, {"case": "gyroid-8M", "method": "opengl, vertex shader",
                                                       "parameter": "composite, unsorted"}),
    "graphics-card.projected": ("graphics-card", TIME, {"case": "gyroid-8M", "method": "projectedtetrahedra"}),
    "interval4d.second": ("interval4d", "{ratio}", SECOND),
    "shadows.one": ("shadows", "{over_off}", shadowed(1)),
    "shadows.two": ("shadows", "{over_one_light}", shadowed(2)),
    "shadows.four": ("shadows", "{over_one_light}", shadowed(4)),
    **{f"shadows.{method}-{number:g}": ("shadows", "{error:2} in {seconds}",
                                        {"case": "rings-128, shaded", "method": method, "parameter": number})
       for method, numbers in (("spacing", (0.5, 1, 2)), ("buffer", (128, 256, 512))) for number in numbers},
    "soft-shadows.hard": ("soft-shadows", "{over_hard}", {"method": "default"}),
    **{f"soft-shadows.samples-{number}": ("soft-shadows", "{error:2} in {seconds}",
                                          {"case": "rings-64", "method": "sample-layers", "parameter": number})
       for number in (4, 16, 64)},
    **{f"scattering.cloud-{mode}": ("scattering", "{error:2}", {"case": "cloud", "parameter": "default",
                                                                "method": mode})
       for mode in ("single", "forward", "full")},
    **{f"scattering.time-{mode}": ("scattering", "{slower}", {"case": "cloud", "parameter": "default",
                                                              "method": mode})
       for mode in ("single", "forward", "full")},
    "flow-speed.images": ("flow-speed", "{ratio}", {"case": ("image-64", "image-128"), "method": "equal-error"}),
    "flow-speed.hexahedra": ("flow-speed", "{ratio}", {"case": "hexahedra-64", "method": "equal-error"}),
    "flow-speed.tetrahedra": ("flow-speed", "{ratio}", {"case": "tetrahedra-64", "method": "equal-error"}),
    **{f"flow.abc-{name}": ("flow", "{error:2} in {seconds}", {"case": "abc", "method": "automatic",
                                                               "parameter": number})
       for name, number in (("coarse", 1e-3), ("default", 1e-6), ("fine", 1e-9))},
    "flow-texture.rgba": ("flow-texture", "{slower}", {"method": "textures", "peer": "gpu-rgba"}),
    "flow-texture.components": ("flow-texture", "{ratio}", {"method": "textures", "peer": "gpu"}),
    "commands.scene": ("commands", "{minutes:2} minutes", {"case": "Utilities/demo --scene bonsai"}),
    "mixed.budget": ("mixed", "{over_budget}", {"method": "scene-pass", "peer": "volume + 2 actors"}),
}


def ratios(suite, work, data, peer, rows):
    """Describes a line of a table of ratios: a suite, its task, data, baseline and rows."""
    return {"suite": suite, "work": work, "data": data, "peer": peer, "rows": rows}


CASTER = "`vtkGPUVolumeRayCastMapper`"
FRAME = "CT, 256² x 128{}, 512², llvmpipe, two threads; Interlume at its defaults, slices half a voxel apart"
UNADJUSTED = "one sample per voxel, no automatic sample distances (not its defaults)"
RATIO_LINES = [
    *(ratios("interval", "extract tetrahedra between two values", words,
             "`vtkTableBasedClipDataSet` twice (mixed cells) / followed by `vtkDataSetTriangleFilter` (tetrahedra)",
             [{"case": case, "peer": peer, **INTERVAL} for peer in ("clip2", "clip2-tetrahedra")])
      for case, words in DATA.items()),
    ratios("contour", "extract an isosurface of image data", "wavelet", "`vtkFlyingEdges3D`",
           [{"case": "wavelet-97", "method": "isotable-image", "peer": "flyingedges", **ONE}]),
    ratios("contour", "extract an isosurface of unstructured hexahedra", "wavelet",
           "`vtkContour3DLinearGrid`, separate points / shared points",
           [{"case": "wavelet-97", "method": "isotable-hexahedra-unmerged", "peer": "contour3dlinear", **ONE},
            {"case": "wavelet-97", **HEXAHEDRA}]),
    *(ratios("tetrahedra", f"render tetrahedra as a volume, {words}",
             " / ".join(SIZES.values()) + " tetrahedra, 512², llvmpipe, two threads", "`vtkProjectedTetrahedraMapper`",
             [{"case": case, "method": path, "parameter": "composite", "peer": "projectedtetrahedra", "error": None}
              for case in SIZES]) for path, words in (("software", "software path"), ("opengl", "OpenGL path"))),
    ratios("shadows", "render a volume with one light, without shadows",
           FRAME.format(" / 256³ / sphere / rings, 128³"),
           f"{CASTER} with Shade, {UNADJUSTED}",
           [{"case": case, "method": "shadows-off", "peer": "gpu"}
            for case in ("bonsai-256x256x128", "bonsai-256x256x256", "sphere-128", "rings-128")]),
    ratios("shadows", "render a volume with the shadows of one light", FRAME.format(""),
           f"{CASTER} with Shade, volumetric shadows of full reach, {UNADJUSTED}",
           [{"case": "bonsai-256x256x128", "method": "shadows", "peer": "gpu-shadows"}]),
    ratios("shadows", "render an isotropically scattering volume with the shadows of one light, at equal error",
           "sphere / rings / CT, 128³, 256²; Interlume at its defaults",
           f"{CASTER} with volumetric shadows of full reach, sample distance reduced to the same error",
           [{"case": f"{case}, scattering", "method": "equal-error"}
            for case in ("sphere-128", "rings-128", "bonsai-128x128x128")]),
    *(ratios("flow-speed", "find the ends of streamlines, at equal error", f"ABC flow, {words}, 2048 streamlines",
             "`vtkStreamTracer`, RK4 / RK45", [{"case": case, **equal_error(integrator)}
                                               for integrator in ("RK4", "RK45")])
      for case, words in (("image-64", "image 64³"), ("image-128", "image 128³"),
                          ("hexahedra-64", "64³ points, hexahedra"), ("tetrahedra-64", "64³ points, tetrahedra"))),
]
# The README's rows: the largest losses, threads, a graphics card, and one row for each task.
README_LINES = [
    ratios("shadows", "volume without shadows", "CT 256³ / rings 128³", "`vtkGPUVolumeRayCastMapper`",
           [{"case": case, "method": "shadows-off", "peer": "gpu"} for case in ("bonsai-256x256x256", "rings-128")]),
    ratios("contour", "isosurface", "image 97³", "`vtkFlyingEdges3D`",
           [{"case": "wavelet-97", "method": "isotable-image", "peer": "flyingedges", **ONE}]),
    ratios("tetrahedra", "tetrahedra as a volume, OpenGL on a CPU", "0.3 M / 8 M", "`vtkProjectedTetrahedraMapper`",
           [{"case": case, "method": "opengl", "parameter": "composite", "peer": "projectedtetrahedra", "error": None}
            for case in ("gyroid-0.3M", "gyroid-8M")]),
    ratios("interval", "tetrahedra between two values, two threads", "image 97³ / disk", "one thread",
           [{"case": case, **SECOND} for case in ("wavelet-97", "disk-out")]),
    ratios("interval", "tetrahedra between two values", "image 97³ / disk", "`vtkTableBasedClipDataSet` twice",
           [{"case": case, "peer": "clip2", **INTERVAL} for case in ("wavelet-97", "disk-out")]),
    ratios("shadows", "volume with the shadows of a light", "CT 256² x 128",
           "`vtkGPUVolumeRayCastMapper`, volumetric shadows",
           [{"case": "bonsai-256x256x128", "method": "shadows", "peer": "gpu-shadows"}]),
    ratios("graphics-card", "tetrahedra as a volume, NVIDIA H200", "8 M", "`vtkProjectedTetrahedraMapper`",
           [{"case": "gyroid-8M", "method": "opengl, vertex shader", "parameter": "composite"}]),
    ratios("flow-speed", "ends of streamlines, equal error", "image 64³", "`vtkStreamTracer`, RK4 / RK45",
           [{"case": "image-64", **equal_error(integrator)} for integrator in ("RK4", "RK45")]),
]
