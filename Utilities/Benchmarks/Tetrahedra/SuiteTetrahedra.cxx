// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tetrahedra/TetrahedraParts.h"
#include "Benchmarks/Suites/BenchSuites.h"

BenchSuite MakeTetrahedraSuite()
{
  return { "tetrahedra", "vtkTimeWeightedTetrahedraMapper: run time and error against run time",
    { "One frame of a gyroid in cubes of five tetrahedra, off-screen, until OpenGL says it is "
      "done. The camera turns by half a degree from frame to frame, so that sorting is part of "
      "each. Methods opengl and software are the render paths, on the device that the counts name; "
      "the peer projectedtetrahedra is vtkProjectedTetrahedraMapper, one of the methods that take "
      "turns in the same window. sort_seconds is the time over that of the same mode without a "
      "sort.",
      "Error against run time: pictures of the same field on ever finer meshes, in a float "
      "framebuffer, against the picture of the formula by 4000 steps along each line of sight. "
      "raycast and zsweep are vtkUnstructuredGridVolumeRayCastMapper and "
      "vtkUnstructuredGridVolumeZSweepMapper with the linear integrator and a ray for each pixel; "
      "both round to 8 bits. The mesh's own error is in every method's." },
    { tetrahedra::MakeSpeedPart(), tetrahedra::MakeErrorPart() } };
}
