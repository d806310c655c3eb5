// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeFlowSpeedSuite()
{
  return { "flow-speed",
    "vtkImplicitFlowField against vtkStreamTracer: run time, error against run time",
    {
      "image, hexahedra, tetrahedra: one period of ABC flow, backward from random seeds to a box "
      "just inside the field, 1 thread; the points of the unstructured grids are moved by up to a "
      "tenth of a cell. streamtracer is vtkStreamTracer without vorticity, with the fastest of its "
      "ways to find cells: the default on images, vtkStaticCellLocator on unstructured grids "
      "(vtkModifiedBSPTree and the default's point locator were slower). RK4: the parameter is the "
      "step in lengths of a cell; RK45: MaximumError, steps up to two cells. Its steps are those "
      "of its output. Both work on the field that VTK interpolates. The error is the mean distance "
      "of the ends from the streamlines of that field, by Boost's runge_kutta_fehlberg78: on "
      "images in steps that end at the faces of cells, good to 1e-12; else in steps of at most a "
      "tenth of a cell through VTK's interpolation, good to some 1e-8. time_error is the mean "
      "error of the time at the end: vtkStreamTracer keeps time to first order only.",
      "equal-error: the default of vtkImplicitFlowField against the first setting of streamtracer, "
      "the step halved or MaximumError divided by ten each time, whose error is at most twice as "
      "large, or below 3e-8, to which its points in single precision are rounded. "
      "steps_per_second_ratio compares steps a second of processor time at those settings, without "
      "what one streamline takes with all that is made of the field first, setup_seconds; the "
      "ratio of times is that of samples a second. equal-error-again: the same filter executed "
      "again on the same grid, of which it has kept which faces meet, kept_faces. threads-2: two "
      "threads against one.",
    },
    { flow::MakeSpeedPart() } };
}
