# SPDX-License-Identifier: BSD-3-Clause
"""Tests random sequences of changes of input, array and intervals: a filter must have the same output as a new
one with the same values, and default intervals unless they were set.
"""

import random

import numpy
from paraview import simple

from plugin_testing import as_set, fetch, open_data, run, warnings_of
from simplex_measures import simplices

STEPS = 60


def proposal(source, array):
    lowest, highest = source.PointData.GetArray(array).GetRange()
    return [(lowest + highest) / 2, highest]


def main(checks):
    generator = random.Random(16)
    full = open_data("disk_out_ref")
    half = simple.Clip(Input=full)
    half.UpdatePipeline()
    sources = [full, half]
    arrays = ["AsH3", "CH4", "Pres", "Temp"]
    source, array, is_set = full, "AsH3", False
    reused = simple.IntervalVolume(Input=full)
    reused.Scalars = ["POINTS", array]
    expected = proposal(full, array)
    for step in range(STEPS):
        change = generator.choice(("input", "array", "array", "set", "reset", "update"))
        if change == "input":
            other = generator.choice(sources)
            if other is not source and not is_set:
                expected = proposal(other, array)
            source = other
            reused.Input = source
        elif change == "array":
            other = generator.choice(arrays)
            if other != array and not is_set:
                expected = proposal(source, other)
            array = other
            reused.Scalars = ["POINTS", array]
        elif change == "set":
            lowest, highest = source.PointData.GetArray(array).GetRange()
            fraction = generator.uniform(0.2, 0.4)
            expected = [lowest + fraction * (highest - lowest), lowest + 0.7 * (highest - lowest)]
            is_set = True
            reused.Intervals = expected
        elif change == "reset":
            reused.SMProxy.GetProperty("Intervals").ResetToDomainDefaults()
            reused.SMProxy.UpdateVTKObjects()
            expected, is_set = proposal(source, array), False
        checks.equal(list(reused.Intervals), expected, f"intervals after step {step}, {change}")
        fresh = simple.IntervalVolume(Input=source)
        fresh.Scalars = ["POINTS", array]
        fresh.Intervals = expected
        with warnings_of(reused) as messages, warnings_of(fresh) as fresh_messages:
            found, wanted_grid = fetch(reused), fetch(fresh)
        checks.equal(bool(fresh_messages), wanted_grid.GetNumberOfCells() == 0, f"a message after step {step}")
        checks.that(not messages or found.GetNumberOfCells() == 0, f"no unexpected message after step {step}")
        same = found.GetNumberOfCells() == wanted_grid.GetNumberOfCells() and (
            found.GetNumberOfCells() == 0 or
            numpy.array_equal(as_set(simplices(found)), as_set(simplices(wanted_grid))))
        checks.that(same, f"tetrahedra after step {step}, {change}")
        simple.Delete(fresh)


run(main)
