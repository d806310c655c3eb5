// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Intervals/IntervalParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeIntervalSuite()
{
  return { "interval", "vtkIntervalVolume: run time, memory, orientation, error against run time",
    { "interval-volume: tetrahedra of vtkIntervalVolume, made anew each time, against clip2, two "
      "passes of vtkTableBasedClipDataSet, which give mixed cells, and clip2-tetrahedra, which "
      "makes them tetrahedra by vtkDataSetTriangleFilter. Each dataset has one point array.",
      "threads-2: the same extraction by two threads against one.",
      "re-extract: an interval that changes from run to run, as with a slider, with the index of "
      "value ranges against a pass over all cells, in the middle of the range of values, where it "
      "passes through most of the domain, and at its end. The parameter is the interval's width as "
      "a share of the range of values; share is the share of cells with output.",
      "drag, drag-tied: the lower bound of an interval up to the end of the range goes on by a two "
      "hundredth of the range, low, in the middle and high in it, with KeepMemory, against without "
      "(new-memory) and against a copy of as many bytes as the output has, between memory that is "
      "there (copy). Bounds equal no value of the data, or, drag-tied, are whole numbers, as the "
      "data are. changed is the number of cells that the bound passes through between two updates, "
      "share their share.",
      "whole-cells: the same with KeepWholeCells, against without (tetrahedra) and against clip2, "
      "which keeps whole cells too; output_kib is the size of the output, growth_kib by how much "
      "the resident memory of a process of its own grew at most.",
      "memory: in a process of its own; peak_kib is the input and the largest growth of resident "
      "memory; peak_share is the growth divided by the output; first_use_kib, which the tables and "
      "the code took before, is not in it.",
      "cold: the first extraction in a fresh process, where tables are still to be filled, against "
      "the second (peer warm).",
      "inverted: tetrahedra of negative volume; the error is the share of volume that they hold.",
      "hexahedra, hexahedra-unstructured, tetrahedra-5, -6, -24, clip2: error against run time on "
      "analytic fields, for the grid as it is, as unstructured hexahedra, split beforehand into "
      "tetrahedra (seconds without the split), and clipped twice. The reference is the exact "
      "region of the trilinear interpolant of the grid's values." },
    { interval::MakeSpeedPart(), interval::MakeDragPart(), interval::MakeWholePart(),
      interval::MakeMemoryPart(), interval::MakeOrientationPart(), interval::MakeErrorPart() } };
}
