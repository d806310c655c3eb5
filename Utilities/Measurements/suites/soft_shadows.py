# SPDX-License-Identifier: BSD-3-Clause
"""Suite soft-shadows: shadows of area lights in vtkShadowedSliceMapper."""

from measured_cells import NOTHING, Cell, count, error_of, joined, short
from measured_tables import Table

SCENES = ("rings", "bonsai", "smoke", "box")
NAMES = {"sample-layers": "layers", "sampled-lights": "lights of samples", "hard": "hard shadows"}


def of_scene(scene):
    return lambda name: name is not None and name.startswith(scene + "-")


class OverHard(Cell):
    """Processor time over that of hard shadows in the same scene."""

    def __call__(self, run, line, by=None):
        row = self.row(run, line, by)
        hard = run.select(method="hard", case=self.fields["case"])
        if row is None or not hard:
            return NOTHING
        if "over_hard" in row["counts"]:
            return short(row["counts"]["over_hard"])
        return short(row["counts"]["processor_seconds"] / hard[0]["counts"]["processor_seconds"], 2)


TABLES = {
    "soft-shadows.methods": Table("soft-shadows", [
        (scene, joined("{}, {}", error_of(short, case=of_scene(scene)), OverHard(None, None, case=of_scene(scene))))
        for scene in SCENES], head="method, parameter", by=("method", "parameter"), names=NAMES,
        method=lambda name: name != "equal-time"),
    "soft-shadows.equal-time": Table("soft-shadows", [
        ("error of the convolution at equal time, over that of the default", count("convolution_over_default"))],
        head="scene", method="equal-time"),
}
VALUES = {}
