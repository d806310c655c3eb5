// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowCases_h
#define FlowCases_h

#include "Benchmarks/Suites/BenchOptions.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

/**
 * Data of the flow suites.
 */
namespace flow
{
/**
 * A field, the start points of streamlines, and the box at whose faces streamlines end.
 */
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Field;
  vtkSmartPointer<vtkPolyData> Seeds;
  std::array<double, 6> Box;
  /// Whether the field is an image, in which VTK locates cells by index arithmetic.
  bool IsBoxGrid = false;
};

/// Returns a source of one period of ABC flow at points^3 points in [-1, 1]^3.
vtkSmartPointer<vtkAnalyticFlowSource> MakeBeltrami(int points);

/// Returns \a number pseudo-random points, uniformly distributed in the cube [-half, half]^3.
vtkSmartPointer<vtkPolyData> MakeSeeds(int number, double half, unsigned int seed);

/**
 * Returns ABC flow on images (`image-64`, `image-128`) and on unstructured grids whose points are
 * displaced by up to a tenth of a cell (`hexahedra-64`, and `tetrahedra-64` with five tetrahedra
 * per cell). \a options may select smaller sizes.
 */
std::vector<Case> MakeSpeedCases(const BenchOptions& options);
}

#endif
