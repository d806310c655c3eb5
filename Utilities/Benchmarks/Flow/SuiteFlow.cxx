// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeFlowSuite()
{
  return { "flow", "vtkImplicitFlowField, vtkFlowVolume: error against run time, stream volumes",
    {
      "uniform, rotation, saddle, spiral, stiff: linear fields, which interpolation keeps, so that "
      "streamlines are known by formulas; source-sink, sphere, abc: against streamlines of the "
      "interpolated field as in flow-speed. The parameter is MaximumError over the largest speed; "
      "in stiff fields, saddles of that ratio of eigenvalues that damp backward, MaximumError. "
      "within: the share of the answers that are no further than 10 MaximumError times their time "
      "from where the field carries the sample in that time. RK4 and RK45 are those of "
      "vtkStreamTracer.",
      "hurricane: advection of as many samples, at most 10 units of time; new stream volumes when "
      "the inflow mapping, the interval alone, or the range of times alone changes, against that "
      "advection. advections: how often it was done again. checkpoints, checkpoints-often: the "
      "same advection with a checkpoint each minute, and whenever the last one took less than a "
      "tenth of the time since, against that without; written: how often there was one.",
      "conservation: stream volumes from a disc in fields without divergence, the flux through "
      "five time surfaces against that through the disc.",
      "contraction, beside, around: the stream volume of a disc where it is known by formulas, "
      "Zhang's table 4.1 measured. explicit: a patch of triangles carried along by vtkRungeKutta4, "
      "in the manner of Max, Becker and Crawfis (1993), the parameter being its rings; "
      "explicit-halved: with edges halved where streamlines part. implicit: vtkImplicitFlowField, "
      "vtkInflowMapping and vtkFlowVolume, the parameter being samples a side; implicit-again: the "
      "same after a change of the mapping; implicit-refined: with two levels of refinement. The "
      "error is the volume of tetrahedra whose middle is outside, and the volume missing, over the "
      "tube's; boundary_distance the distance of the tube's sides, root mean square.",
    },
    { flow::MakeTolerancePart(), flow::MakeVolumePart(), flow::MakeCheckpointPart(),
      flow::MakeConservationPart(), flow::MakeExplicitPart() } };
}
