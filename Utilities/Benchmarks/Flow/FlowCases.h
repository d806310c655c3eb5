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
 * What the suites of flow measure on.
 */
namespace flow
{
/**
 * A field, where streamlines begin, and the box in which all of them end.
 */
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Field;
  vtkSmartPointer<vtkPolyData> Seeds;
  std::array<double, 6> Box;
  /// Whether VTK finds cells of the field by arithmetic.
  bool IsLattice = false;
};

/// ABC flow in [-1, 1]^3, one period, on points^3 points.
vtkSmartPointer<vtkAnalyticFlowSource> MakeBeltrami(int points);

/// So many points, pseudo-random and even in the box of \a half around the origin.
vtkSmartPointer<vtkPolyData> MakeSeeds(int number, double half, unsigned int seed);

/**
 * ABC flow on images (`image-64`, `image-128`), and, with the points moved by up to a tenth of a
 * cell, on unstructured grids of hexahedra and of five tetrahedra a cell (`hexahedra-64`,
 * `tetrahedra-64`); smaller ones by \a options.
 */
std::vector<Case> MakeSpeedCases(const BenchOptions& options);
}

#endif
