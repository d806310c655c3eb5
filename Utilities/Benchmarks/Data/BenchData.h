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
 * A dataset with scalars as its only point array, and the interval to extract. The lower bound is
 * also the isovalue of contours.
 */
struct BenchData
{
  std::string Case;
  vtkSmartPointer<vtkDataSet> Data;
  double Lower = 0.0;
  double Upper = 0.0;
};

/**
 * Returns the geometry and cells of \a from. The point array \a name becomes the scalars; other
 * arrays are omitted. Throws std::runtime_error if the array does not exist.
 */
vtkSmartPointer<vtkDataSet> CopyWithOneArray(vtkDataSet* from, const std::string& name);

constexpr double WaveletLower = 140.0;
constexpr double WaveletUpper = 180.0;

/**
 * Returns a wavelet source with points^3 points.
 */
vtkSmartPointer<vtkRTAnalyticSource> MakeWaveletSource(int points);

/**
 * Returns the case `wavelet-<points>`: vtkRTAnalyticSource on points^3 points, 140 <= f <= 180.
 */
BenchData MakeWavelet(int points);

/**
 * Returns the number of points of the wavelet along each axis: 97, 41 or 13.
 */
int GetWaveletResolution(const BenchOptions& options);

/**
 * Returns the cases of the suites interval and contour: the wavelet, and data files with images, a
 * curvilinear grid and an unstructured hexahedral grid. Throws std::runtime_error if a file cannot
 * be read.
 */
std::vector<BenchData> MakeSpeedCases(const BenchOptions& options);

/**
 * Returns the case of MakeSpeedCases() with this name. Throws std::runtime_error if there is no
 * such case.
 */
BenchData MakeSpeedCase(const std::string& name, const BenchOptions& options);

/**
 * Returns the points, cells and point scalars of \a data as a vtkUnstructuredGrid, with voxels
 * converted to hexahedra.
 */
vtkSmartPointer<vtkUnstructuredGrid> ToHexahedra(vtkDataSet* data);

/**
 * Returns the case `random-<type>`: cells without shared points, of type VTK_TETRA, VTK_PYRAMID,
 * VTK_WEDGE or VTK_HEXAHEDRON. All cells have the same corners and the bounding box [0, 1]^3.
 * Scalars are random with uniform distribution in [0, 1], and the interval is [0.3, 0.7].
 */
BenchData MakeRandomCells(int cellType, int numberOfCells, unsigned int seed);

#endif
