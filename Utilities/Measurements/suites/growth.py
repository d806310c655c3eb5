# SPDX-License-Identifier: BSD-3-Clause
"""Suite growth: run time and memory against N."""

from measured_cells import count, error, mebibytes_of_kib, seconds, time
from measured_tables import Table


def exponents(method):
    """Fitted exponents beside theory's."""
    return Table("growth", [
        ("fitted", count("exponent", error)), ("theory, from", count("least", error)),
        ("to", count("most", error)), ("sizes", count("sizes")), ("largest over smallest", count("factor"))],
        head="N, and why", by=("case", "parameter"), method=method)


def is_computed(name):
    return name.startswith("computed: ")


TABLES = {
    "growth.time": exponents("time exponent"),
    "growth.memory": exponents("memory exponent"),
    "growth.wall": exponents("wall exponent"),
    "growth.sizes": Table("growth", [
        ("processor time", count("processor_seconds", seconds)), ("wall time", time()),
        ("memory over the input, MiB", count("kib", mebibytes_of_kib)),
        ("input, MiB", count("input_kib", mebibytes_of_kib))],
        head="N", by=("case", "parameter"), method="growth"),
    "growth.cluster": Table("growth", [
        ("computed time", count("computed_seconds", seconds)),
        ("memory of a rank, MiB", count("kib_a_rank", mebibytes_of_kib)),
        ("of it time steps, MiB", count("input_kib_a_rank", mebibytes_of_kib))],
        head="computed, ranks", by=("method", "parameter"), method=is_computed),
}
VALUES = {}
