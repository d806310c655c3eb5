# SPDX-License-Identifier: BSD-3-Clause
"""Tests that time-varying interval volumes and their slices in ParaView equal the results of the C++ classes, also
for composite datasets and regardless of the time that ParaView shows.
"""

import numpy
from paraview import simple

from extraction_measures import compare
from plugin_testing import (
    as_set, fetch, leaves, output_in_place, read_extractions, run, temporal_source, time_varying_volume)
from simplex_measures import integrals, simplices

PORTS = (("tetrahedra", "SimplexClass"), ("boundaries", "BoundaryKind"), ("simplices", "TimeSlab"))


def slice_at(volume, time):
    simplex_slice = simple.SimplexTimeSlice(Input=simple.OutputPort(volume, 2))
    simplex_slice.Time = time
    return simplex_slice


def repeat(checks, name, extraction):
    source = temporal_source(extraction["source"], extraction["source_properties"])
    volume = time_varying_volume(source, extraction["properties"])
    for port, (output, id_array) in enumerate(PORTS):
        compare(checks, f"{name}, {output}", fetch(volume, port), extraction[output], id_array)
    for time, expected in zip(extraction["slice_times"], extraction["slices"]):
        found = fetch(slice_at(volume, time))
        compare(checks, f"{name}, slice at {time}", found, expected, "IntervalId")


def check_time(checks, extraction):
    """Tests that the output covers all times, is computed once, and has no time steps."""
    source = temporal_source(extraction["source"], extraction["source_properties"])
    volume = time_varying_volume(source, extraction["properties"])
    times_of_points = set()
    for time in (1.0, 0.7, 5.0):
        volume.UpdatePipeline(time)
        grid = output_in_place(volume)
        compare(checks, f"shown at {time}", grid, extraction["tetrahedra"], "SimplexClass")
        times_of_points.add(grid.GetPoints().GetMTime())
    checks.equal(len(times_of_points), 1, "executions for three times")
    for proxy, steps in ((source, extraction["source_properties"]["NumberOfTimeSteps"]), (volume, 0)):
        information = proxy.GetDataInformation().DataInformation
        checks.equal(information.GetNumberOfTimeSteps(), steps, f"{proxy.SMProxy.GetXMLName()}, time steps")


def check_composite(checks, extraction):
    """Tests that a group produces a group of the same structure, with the simplices of each source."""
    properties = extraction["properties"]
    sources = []
    for shift in (0.0, 0.3):
        source = temporal_source(extraction["source"], extraction["source_properties"])
        source.Bounds = [bound + shift for bound in extraction["source_properties"]["Bounds"]]
        sources.append(source)
    group = simple.GroupDatasets(Input=sources)
    group.UpdatePipeline()
    volume = time_varying_volume(group, properties)
    slices = slice_at(volume, extraction["slice_times"][0])
    kind = output_in_place(group).GetClassName()
    for port, (output, id_array) in enumerate(PORTS):
        grids = list(leaves(output_in_place(volume, port)))
        checks.equal(output_in_place(volume, port).GetClassName(), kind, f"group, {output}")
        checks.equal(len(grids), len(sources), f"group, leaves of {output}")
        compare(checks, f"first of a group, {output}", grids[0], extraction[output], id_array)
    checks.equal(output_in_place(slices).GetClassName(), kind, "group, slices")
    ungrouped = time_varying_volume(sources[1], properties)
    for grouped, single, port in ((volume, ungrouped, 2), (slices, slice_at(ungrouped, slices.Time), 0)):
        found = as_set(simplices(list(leaves(output_in_place(grouped, port)))[1]))
        expected = as_set(simplices(fetch(single, port)))
        checks.that(len(expected) > 0, "the second leaf has simplices")
        checks.that(numpy.array_equal(found, expected), "the second leaf equals the output without a group")


def check_criteria(checks, extraction):
    """Tests that the parts that satisfy a criterion, and that do not, together have the extent of all."""
    source = temporal_source(extraction["source"], extraction["source_properties"])
    calculator = simple.Calculator(Input=source, ResultArrayName="side", Function="coordsX")
    calculator.UpdatePipeline()
    volume = time_varying_volume(calculator, extraction["properties"])

    def extent():
        return integrals(fetch(volume), "DeltaT").sum()

    everything = extent()
    low, high = fetch(volume).GetPointData().GetArray("side").GetRange()
    bound = low + 0.4 * (high - low)
    volume.Criteria = ["side", str(low), str(bound)]
    inside = extent()
    checks.that(fetch(volume).GetPointData().GetArray("side").GetRange()[1] < bound + 1e-4 * (high - low), "values")
    volume.CombineCriteria = "Difference"
    outside = extent()
    checks.that(0 < inside < everything and abs(inside + outside - everything) <= 1e-5 * everything,
                f"parts of a criterion: {inside} and {outside} of {everything}")
    volume.Criteria = ["side", str(low - 0.5), str(bound)]
    volume.CombineCriteria = "Union"
    # The intervals contain the values of the x coordinate from low to high.
    expected = everything * (high - low + 0.5) / (high - low)
    united = extent()
    ids = fetch(volume).GetCellData().GetArray("IntervalId").GetRange()
    checks.that(ids[0] == -1 and abs(united - expected) <= 1e-5 * expected,
                f"union of {united} instead of {expected}, ids from {ids[0]}")


def main(checks):
    extractions = read_extractions("time_varying.json")
    for number, extraction in enumerate(extractions):
        name = f"{number}: {extraction['source']}"
        print(name, flush=True)
        repeat(checks, name, extraction)
    check_time(checks, extractions[0])
    check_composite(checks, extractions[0])
    check_criteria(checks, extractions[0])


run(main)
