// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchData_h
#define BenchData_h

#include "Benchmarks/Suites/BenchOptions.h"

#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

class vtkRTAnalyticSource;

/**
 * A dataset with nothing on it but the point scalars it is extracted by, and the interval that is
 * extracted. The lower bound is also the contour value.
 */
struct BenchData
{
  std::string Case;
  vtkSmartPointer<vtkDataSet> Data;
  double Lower = 0.0;
  double Upper = 0.0;
};

/**
 * The structure of \a from with nothing on it but that point array, as the scalars. Throws
 * std::runtime_error where there is no such array.
 */
vtkSmartPointer<vtkDataSet> WithOneArray(vtkDataSet* from, const std::string& name);

constexpr double WaveletLower = 140.0;
constexpr double WaveletUpper = 180.0;

/**
 * A source of points^3 points.
 */
vtkSmartPointer<vtkRTAnalyticSource> MakeWaveletSource(int points);

/**
 * The scalars of vtkRTAnalyticSource on points^3 points, 140 <= f <= 180: `wavelet-<points>`.
 */
BenchData MakeWavelet(int points);

/**
 * The points of the wavelet that stands for the size: 97, 41 or 13.
 */
int WaveletPoints(const BenchOptions& options);

/**
 * The wavelet and the real sets of the interval and contour suites: image data, a curvilinear grid
 * and an unstructured hexahedral grid. Throws std::runtime_error where a set cannot be read.
 */
std::vector<BenchData> MakeSpeedCases(const BenchOptions& options);

/**
 * The case of MakeSpeedCases() with that name. Throws std::runtime_error where there is none.
 */
BenchData MakeSpeedCase(const std::string& name, const BenchOptions& options);

/**
 * The same points, cells and point scalars as a vtkUnstructuredGrid; voxels become hexahedra.
 */
vtkSmartPointer<vtkUnstructuredGrid> ToHexahedra(vtkDataSet* data);

/**
 * Many cells that share no point, of type VTK_TETRA, VTK_PYRAMID, VTK_WEDGE or VTK_HEXAHEDRON, each
 * regular, of edge 1 (the pyramid's height is 1 as well), with values uniform in [0, 1]; the
 * interval is [0.3, 0.7]. `random-<type>`.
 */
BenchData MakeRandomCells(int cellType, int numberOfCells, unsigned int seed);

#endif
