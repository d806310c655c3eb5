# SPDX-License-Identifier: BSD-3-Clause
"""Suite interval: vtkIntervalVolume."""

from measured_cells import Cell, count, error, error_of, mebibytes_of_kib, peer_time, percent, ratio, short, slower, time
from measured_tables import Table

from .data_names import DATA
from .spread import single, spread

ONE = {"method": "interval-volume", "parameter": "1 thread"}
CLIP = {**ONE, "peer": "clip2"}
TETRAHEDRA = {**ONE, "peer": "clip2-tetrahedra"}
SECOND = {"method": "threads-2"}
VOLUME = {"error_norm": "volume, relative"}
SURFACE = {"error_norm": "surface distance, rms, share of the domain's edge"}


def visited_share(row):
    return row["counts"]["visited"] / row["counts"]["cells"]


def re_extracted(place):
    return Table("interval", [
        ("cells with output", count("share", percent)),
        ("cells visited", Cell(visited_share, percent)),
        ("time against a pass over all cells", slower())],
        head="width of the interval, share of the range", by="parameter",
        method="re-extract", case=lambda name: name is not None and name.endswith("-" + place))


DRAGS = {f"{case}-{place}": f"{words}, {place}" for place in ("low", "middle", "high")
         for case, words in {"bonsai": "bonsai", "head-ct-256": "CT head"}.items()}


def dragged(method):
    fields = {"method": method, "parameter": "2 threads"}
    kept = {**fields, "peer": "new-memory"}
    return Table("interval", [
        ("cells that change", count("share", percent, **kept)),
        ("tetrahedra", count("tetrahedra", **kept)),
        ("time", peer_time(**kept)),
        ("with `KeepMemory`", time(**kept)),
        ("a copy of the output", peer_time(**fields, peer="copy"))],
        head="data, place of the bound in the range", names=DRAGS, **kept)


def errors(field):
    def columns(method):
        return [(f"{method}: volume", error_of(case=field, method=method, **VOLUME)),
                ("surface", error_of(case=field, method=method, **SURFACE)), ("time", time(case=field, method=method, **VOLUME))]
    methods = ("hexahedra", "tetrahedra-5", "tetrahedra-6", "tetrahedra-24", "clip2")
    return Table("interval", [column for method in methods for column in columns(method)],
                 head="points an edge", by="parameter", case=field, **VOLUME)


TABLES = {
    "interval.speed": Table("interval", [
        ("cells", count("cells", **CLIP)),
        ("tetrahedra", count("tetrahedra", **CLIP)),
        ("against clip twice", ratio(**CLIP)),
        ("against clip twice and tetrahedra", ratio(**TETRAHEDRA)),
        ("a second thread", ratio(**SECOND))],
        head="data", names=DATA, **CLIP),
    "interval.end": re_extracted("end"),
    "interval.middle": re_extracted("middle"),
    "interval.drag": dragged("drag"),
    "interval.drag-tied": dragged("drag-tied"),
    "interval.memory": Table("interval", [
        ("output, MiB", count("output_kib", mebibytes_of_kib, method="memory", parameter="unstructured")),
        ("growth / output, structured", count("peak_share", method="memory", parameter="structured")),
        ("growth / output, unstructured", count("peak_share", method="memory", parameter="unstructured"))],
        head="data", names=DATA, method="memory"),
    "interval.inverted": Table("interval", [
        ("tetrahedra", count("tetrahedra")), ("inverted", count("inverted")),
        ("share of them", count("share", error)), ("share of the volume", error_of())],
        head="data", names=DATA, method="inverted"),
    **{f"interval.error-{field}": errors(field) for field in ("sphere", "torus", "gyroid", "product")},
}

VALUES = {
    "interval.memory": ("interval", spread(count("peak_share"), short, method="memory")),
    "interval.second-images": ("interval", spread(ratio(**SECOND), short, case=lambda name: name in (
        "wavelet-97", "wavelet-41", "head-ct", "isabel"))),
    "interval.second-fin": ("interval", single(ratio(**SECOND), case="blunt-fin")),
    "interval.second-disk": ("interval", single(ratio(**SECOND), case="disk-out")),
    "interval.inverted-tetrahedra": ("interval", single(count("inverted"), method="inverted",
                                                        case="random-tetrahedra")),
    "interval.inverted-hexahedra": ("interval", single(count("share", percent), method="inverted",
                                                       case="random-hexahedra")),
    "interval.inverted-hexahedra-volume": ("interval", single(error_of(percent), method="inverted",
                                                              case="random-hexahedra")),
    "interval.inverted-head": ("interval", single(count("inverted"), method="inverted", case="head-ct")),
    "interval.tetrahedra-head": ("interval", single(count("tetrahedra"), method="inverted", case="head-ct")),
}
