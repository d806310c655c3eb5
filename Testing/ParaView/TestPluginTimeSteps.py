# SPDX-License-Identifier: BSD-3-Clause
"""Tests that Time-Varying Interval Volume proposes time steps with which a large series is not too large, and that
large outputs cause one warning.

Argument: a path for a state file.
"""

import sys

from paraview import simple
from vtkmodules.vtkCommonCore import vtkObject

from plugin_testing import fetch, run, temporal_source, time_varying_volume, warnings_of

LIMIT = 5000000
ACCURACY = 1.25
SERIES = {"Dimensions": [64, 64, 64], "NumberOfTimeSteps": 24}


def quietly(action):
    """Returns the result of an action without printing the message about the proposed steps."""
    vtkObject.GlobalWarningDisplayOff()
    try:
        return action()
    finally:
        vtkObject.GlobalWarningDisplayOn()


def steps_of(volume):
    return list(volume.TimeStepRange) + [volume.TimeStepStride]


def propose(volume):
    """Resets the stride, and returns the warnings of its domain."""
    stride = volume.SMProxy.GetProperty("TimeStepStride")
    with warnings_of(stride.FindDomain("vtkSMProposedStepsDomain")) as warnings:
        stride.ResetToDomainDefaults()
    volume.SMProxy.UpdateVTKObjects()
    return warnings


def check_large(checks, source, path):
    """Tests the proposal for a series that has nine million tetrahedra with default intervals."""
    volume = quietly(lambda: simple.TimeVaryingIntervalVolume(Input=source))
    first, last, stride = steps_of(volume)
    checks.equal((first, last), (0, 2147483647), "proposed range")
    checks.that(stride in (2, 3), f"proposed stride: {stride}")
    with warnings_of(volume) as warnings:
        tetrahedra = fetch(volume).GetNumberOfCells()
    checks.equal(warnings, [], "warnings with the proposed steps")
    print(f"stride {stride}: {tetrahedra} tetrahedra", flush=True)
    checks.that(LIMIT / 4 < tetrahedra < ACCURACY * LIMIT, f"{tetrahedra} tetrahedra with the proposed steps")
    checks.one_message(propose(volume), f"Time Step Stride (now {stride})", "message about the proposal")

    volume.SizeWarningLimit = tetrahedra // 4
    checks.one_message(propose(volume), "Not all 24 time steps are selected", "message at a lower limit")
    first, last, longest = steps_of(volume)
    checks.that(longest == 5 and first == 0 and last < 23, f"shortened range: {first} to {last}, stride {longest}")
    with warnings_of(volume) as warnings:
        few = fetch(volume).GetNumberOfCells()
    checks.that(few < ACCURACY * tetrahedra / 4 or last == 5, f"tetrahedra of the shortened range: {few}")
    volume.TimeStepRange = [1, 9]
    checks.one_message(propose(volume), "Shorten Time Step Range", "message about a range that is too long")
    checks.equal(steps_of(volume), [1, 9, 2], "a range that was set is not shortened")

    volume.TimeStepRange = [0, 1]
    volume.TimeStepStride = 1
    volume.SizeWarningLimit = 1000
    with warnings_of(volume) as warnings:
        volume.UpdatePipeline()
    checks.one_message(warnings, "SizeWarningLimit (1000 tetrahedra", "warning of a large output")
    volume.SizeWarningLimit = 0
    with warnings_of(volume) as warnings:
        volume.UpdatePipeline()
    checks.equal(warnings, [], "warnings without a limit")

    # Values that are set, in scripts or in states, are never replaced.
    chosen = quietly(lambda: simple.TimeVaryingIntervalVolume(Input=source, registrationName="chosen"))
    chosen.TimeStepRange = [2, 20]
    chosen.TimeStepStride = 1
    chosen.SizeWarningLimit = 7
    checks.equal(steps_of(chosen), [2, 20, 1], "steps set by a script")
    simple.SaveState(path)
    simple.ResetSession()
    simple.LoadState(path)
    loaded = simple.FindSource("chosen")
    checks.equal(steps_of(loaded), [2, 20, 1], "steps loaded from a state")
    checks.equal(loaded.SizeWarningLimit, 7, "limit loaded from a state")


def check_small(checks):
    """Tests that nothing is proposed for a small series, and for a single time step."""
    for steps in (1, 8):
        source = temporal_source("AnalyticField", {"Field": "Vortex", "NumberOfTimeSteps": steps})
        volume = time_varying_volume(source, {})
        checks.equal(steps_of(volume), [0, 2147483647, 1], f"{steps} small time steps")
        checks.equal(propose(volume), [], f"messages for {steps} small time steps")


def check_static(checks):
    wavelet = simple.Wavelet()
    wavelet.UpdatePipeline()
    volume = simple.IntervalVolume(Input=wavelet)
    volume.SizeWarningLimit = 1000
    with warnings_of(volume) as warnings:
        volume.UpdatePipeline()
    number = volume.GetClientSideObject().GetOutputDataObject(0).GetNumberOfCells()
    checks.one_message(warnings, f"The output will have {number} tetrahedra", "warning of a large output")


def main(checks):
    check_small(checks)
    check_static(checks)
    check_large(checks, temporal_source("DeltaWingVortices", SERIES), sys.argv[1])


run(main)
