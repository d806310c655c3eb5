# SPDX-License-Identifier: BSD-3-Clause
"""Suite ranks, of interlume-bench-ranks: what several processes of one thread each take."""

from measured_cells import count, mebibytes_of_kib, seconds, time
from measured_tables import Table

BY = ("case", "parameter")
TABLES = {
    "ranks.point": Table("ranks", [
        ("cells a rank", count("cells")), ("processor time", count("processor_seconds", seconds)),
        ("computed", count("computed_seconds", seconds)), ("memory of a rank, MiB", count("kib", mebibytes_of_kib)),
        ("computed, MiB", count("computed_kib", mebibytes_of_kib))],
        head="one step, ranks", by=BY, method="interval volume of a step"),
    "ranks.weak": Table("ranks", [
        ("processor time of a rank", count("processor_seconds", seconds)), ("that of one over it", count("efficiency")),
        ("wall time", time())],
        head="as much for each rank, ranks", by=BY, method="weak scaling"),
    "ranks.memory": Table("ranks", [
        ("memory of a rank, MiB", count("kib", mebibytes_of_kib)), ("over that of one", count("share"))],
        head="the same for any number, ranks", by=BY, method="memory"),
}
VALUES = {}
