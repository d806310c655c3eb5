# SPDX-License-Identifier: BSD-3-Clause
"""Suite shadows: vtkShadowedSliceMapper."""

from measured_cells import Cell, count, error, error_of, peer_time, ratio, short, slower, time
from measured_tables import Table

MARCHER = {"error_norm": "channel difference, mean"}
NAMES = {"bonsai-256x256x128": "bonsai 256² x 128", "bonsai-256x256x256": "bonsai 256³", "sphere-128": "sphere 128³",
         "rings-128": "rings 128³"}


def lights(number):
    return {"method": "shadows", "peer": "shadows-off", "parameter": number}


def bounded(row):
    """A ratio that is a bound where the peer does not get to our error."""
    bound = "above " if row["counts"].get("at_least") else ""
    return bound + short(row["ratio"])


OVER_ONE = "over_one_light"
TABLES = {
    "shadows.speed": Table("shadows", [
        ("Shade, one light, no shadows", time(method="shadows-off", peer="gpu")),
        ("one light with shadows", time(**lights(1))),
        ("over no shadows", count("over_off", **lights(1))),
        ("two lights, over one", count(OVER_ONE, **lights(2))),
        ("four lights, over one", count(OVER_ONE, **lights(4))),
        ("two lights on both sides, over one", count(OVER_ONE, method="shadows, both sides")),
        ("neither Shade nor shadows, over no light in the scene", slower(method="unlit")),
        ("`gpu`, one light: its time over ours", ratio(method="shadows-off", peer="gpu")),
        ("`gpu-shadows`, one light: its time over ours", ratio(method="shadows", peer="gpu-shadows"))],
        head="data", names=NAMES, **lights(1)),
    "shadows.equal-error": Table("shadows", [
        ("error of ours at its default", error_of(error)),
        ("time of ours", time()), ("`gpu-shadows` at that error", peer_time()),
        ("ratio", Cell(bounded, str))],
        head="case", method="equal-error", **MARCHER),
    "shadows.surfaces": Table("shadows", [
        ("mean", error_of(error)), ("p95", count("p95", error)), ("largest", count("largest", error)),
        ("rms over the mean", count("rms", error)), ("brightness", count("brightness", error)),
        ("time over no shadows", slower())], head="surface", method="surfaces"),
}
VALUES = {}
