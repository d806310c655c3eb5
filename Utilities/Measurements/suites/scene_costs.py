# SPDX-License-Identifier: BSD-3-Clause
"""Suite scene-costs, of interlume-bench-costs: what scenes of the gallery pay for what they do not use."""

from measured_cells import count, joined, short, time
from measured_tables import Table

COUNTERS = ("passes", "buffers", "bytes", "words", "arrays", "own")
LEFT = [*((name, count(name)) for name in COUNTERS), ("ms", count("ms")), ("noise, ms", count("noise_ms")),
        ("within noise", joined("{} of {}", count("within_noise"), count("timed")))]


def kibibytes(number):
    return short(round(number / 1024, 1))


def is_there(part):
    return part is not None


TABLES = {
    "scene-costs.left": Table("scene-costs", [("scenes without it", count("scenes")), *LEFT],
                              head="feature that is off", by=("method", "parameter"), case="all scenes",
                              parameter=is_there),
    "scene-costs.added": Table("scene-costs", [
        ("passes", count("on_passes")), ("buffers", count("on_buffers")), ("KiB", count("on_bytes", kibibytes)),
        ("words", count("on_words")), ("arrays", count("on_arrays")), ("ms", count("on_ms"))],
        head="feature that is on", by=("method", "parameter"), case="all scenes", parameter=is_there),
    "scene-costs.scenes": Table("scene-costs", [("features it does not use", count("features")), *LEFT],
                                head="scene", method="all features"),
    "scene-costs.classes": Table("scene-costs", [
        ("scenes that execute it", count("scenes")), ("others", count("others")), ("executions", count("executions")),
        ("arrays", count("arrays")), ("KiB", count("bytes", kibibytes)), ("time", time())],
        head="class, medians", by="method", case="all scenes", parameter=None),
}
VALUES = {}
