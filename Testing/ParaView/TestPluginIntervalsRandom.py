# SPDX-License-Identifier: BSD-3-Clause
"""After any sequence of changes of input, array and intervals a filter gives what a fresh one gives with
the same values, and its intervals are proposed unless they were set."""

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
    chance = random.Random(16)
    whole = open_data("disk_out_ref")
    half = simple.Clip(Input=whole)
    half.UpdatePipeline()
    sources = [whole, half]
    arrays = ["AsH3", "CH4", "Pres", "Temp"]
    source, array, is_set = whole, "AsH3", False
    kept = simple.IntervalVolume(Input=whole)
    kept.Scalars = ["POINTS", array]
    expected = proposal(whole, array)
    for step in range(STEPS):
        change = chance.choice(("input", "array", "array", "set", "reset", "update"))
        if change == "input":
            other = chance.choice(sources)
            if other is not source and not is_set:
                expected = proposal(other, array)
            source = other
            kept.Input = source
        elif change == "array":
            other = chance.choice(arrays)
            if other != array and not is_set:
                expected = proposal(source, other)
            array = other
            kept.Scalars = ["POINTS", array]
        elif change == "set":
            lowest, highest = source.PointData.GetArray(array).GetRange()
            share = chance.uniform(0.2, 0.4)
            expected = [lowest + share * (highest - lowest), lowest + 0.7 * (highest - lowest)]
            is_set = True
            kept.Intervals = expected
        elif change == "reset":
            kept.SMProxy.GetProperty("Intervals").ResetToDomainDefaults()
            kept.SMProxy.UpdateVTKObjects()
            expected, is_set = proposal(source, array), False
        checks.equal(list(kept.Intervals), expected, f"intervals after step {step}, {change}")
        fresh = simple.IntervalVolume(Input=source)
        fresh.Scalars = ["POINTS", array]
        fresh.Intervals = expected
        with warnings_of(kept) as said, warnings_of(fresh) as fresh_said:
            found, wanted = fetch(kept), fetch(fresh)
        checks.equal(bool(fresh_said), wanted.GetNumberOfCells() == 0, f"said after step {step}")
        checks.that(not said or found.GetNumberOfCells() == 0, f"said of the other after step {step}")
        same = found.GetNumberOfCells() == wanted.GetNumberOfCells() and (
            found.GetNumberOfCells() == 0 or
            numpy.array_equal(as_set(simplices(found)), as_set(simplices(wanted))))
        checks.that(same, f"tetrahedra after step {step}, {change}")
        simple.Delete(fresh)


run(main)
