// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/Interval4dParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeInterval4dSuite()
{
  return { "interval4d",
    "vtkTimeVaryingIntervalVolume: run time, tables, memory, counts, error against run time",
    { "The time steps are in memory, with one point array, so that the filter alone is timed; it "
      "makes projected tetrahedra. vortex and wave are fields of vtkAnalyticFieldSource, cylinder "
      "and delta those of vtkTaperedCylinderSource and vtkDeltaWingSource, which stand in for the "
      "data of the source, C. Zhang, dissertation, Ohio State 2006, with the number of time steps; "
      "mug is real. stated_ are the counts of the source. warm: the table holds every case. "
      "threads-2: two threads against one. throughput: 4-simplices a second; the parameter is the "
      "share of points inside.",
      "cold: the first execution in a fresh process, 1 thread, against later ones in the same one "
      "(peer warm). hit_share is the share of lookups that found their case made; kind_hit_share "
      "counts those too that found a case of the same kind, that is equal up to a symmetry of the "
      "cell: only a new kind needs a convex hull. later-slabs: the same for all slabs but the "
      "first. memory: in a process of its own; peak_kib is two time steps and the largest growth "
      "of resident memory; peak_share is that divided by two time steps and the output.",
      "slice, interpolate, sampled: the regions midway between every two time steps as the time "
      "step (the parameter) is halved, as slices of 4-simplices; from the mean of the values of "
      "both steps; from the field itself at that time. The reference is the region of the formula. "
      "order: the exponent of errors above four times that of sampled. slice-again: one more slice "
      "of the same 4-simplices." },
    { interval4d::MakeSpeedPart(), interval4d::MakeFreshPart(), interval4d::MakeThroughputPart(),
      interval4d::MakeErrorPart() } };
}
