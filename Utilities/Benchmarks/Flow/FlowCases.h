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
 * A field, the start points of streamlines, and the box where they end.
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

/// Returns one period of ABC flow in [-1, 1]^3 on points^3 points.
vtkSmartPointer<vtkAnalyticFlowSource> MakeBeltrami(int points);

/// Returns \a number pseudo-random points, uniform in the cube with half edge \a half around the
/// origin.
vtkSmartPointer<vtkPolyData> MakeSeeds(int number, double half, unsigned int seed);

/**
 * Returns ABC flow on images (`image-64`, `image-128`) and on unstructured grids of hexahedra and
 * of five tetrahedra per cell (`hexahedra-64`, `tetrahedra-64`), with points displaced by up to a
 * tenth of a cell. \a options may select smaller sizes.
 */
std::vector<Case> MakeSpeedCases(const BenchOptions& options);
}

#endif
