# SPDX-License-Identifier: BSD-3-Clause
"""Suite profiles, of profile_suites.py: where the time goes of rows that miss what is wanted of them."""

from measured_cells import count, percent
from measured_tables import Table

LEAST = 0.03


def largest(shares):
    """The names with at least 3 % of the samples, and what is left."""
    shown = {name: share for name, share in shares.items() if share >= LEAST}
    left = round(1 - sum(shown.values()), 2)
    if left > 0:
        shown["others"] = left
    return ", ".join(f"{name} {percent(round(share, 2))}" for name, share in shown.items())


TABLES = {
    "profiles.rows": Table("profiles", [
        ("samples", count("samples")), ("where", count("shares", largest))],
        head="row", by=("case", "method", "parameter")),
}
VALUES = {}
