# SPDX-License-Identifier: BSD-3-Clause
"""The README's table: ratios to peers, a column for each VTK, losses first."""

from measured_cells import NOTHING, ratio_of, short
from measured_tables import markdown
from suites import README_LINES

# A VTK that so few suites were run with has no column of its own.
FEWEST_SUITES = 3


def ratios(results, line, version):
    """The ratios of a line's rows with that VTK, as numbers and as text; None where one is missing."""
    run = results.runs.get((line["suite"], version))
    if run is None:
        return None
    numbers, texts = [], []
    for fields in line["rows"]:
        found = run.select(**fields)
        if len(found) != 1:
            return None
        numbers.append(ratio_of(found[0]))
        bound = "above " if found[0].get("counts", {}).get("at_least") else ""
        text = bound + short(numbers[-1])
        texts.append(f"**{text}**" if numbers[-1] < 1 else text)
    return numbers, " / ".join(texts)


def readme_table(results):
    versions = results.versions()
    columns = [version for version in versions
               if sum(version == other for suite, other in results.runs) >= FEWEST_SUITES] or versions
    lines = []
    for line in README_LINES:
        found = {version: made for version in versions if (made := ratios(results, line, version))}
        if not found:
            continue
        texts = [found[version][1] if version in found else NOTHING for version in columns]
        apart = [f"{found[version][1]} (VTK {version})" for version in found if version not in columns]
        if apart:
            texts[0] = ", ".join(([texts[0]] if texts[0] != NOTHING else []) + apart)
        smallest = min(min(numbers) for numbers, text in found.values())
        lines.append((smallest, [line["work"], line["data"], line["peer"], *texts]))
    lines.sort(key=lambda one: one[0])
    return markdown(["work", "data", "peer", *(f"ratio, VTK {version}" for version in columns)],
                    [line for smallest, line in lines])
