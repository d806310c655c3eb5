// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTemporalSource_h
#define ReferenceTemporalSource_h

#include "vtkAlgorithm.h"    // for the source
#include "vtkSmartPointer.h" // for it

#include <functional> // for what sources have in common
#include <string>     // for the names
#include <vector>     // for the sources

class vtkDataArray;
class vtkDataSet;
class vtkStructuredGrid;

/**
 * The temporal sources under test by what they have in common, whatever they are derived from.
 */
namespace reference
{

struct TemporalSource
{
  std::string Name;
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  std::function<double(const double x[3], double t)> Evaluate;
  std::function<void(int)> SetNumberOfTimeSteps;
  std::function<int()> GetNumberOfTimeSteps;
  std::function<void(double, double)> SetTimeRange;
  std::function<const double*()> GetTimeRange;
  std::function<void(int)> SetOutputScalarType;
  std::function<int()> GetOutputScalarType;
  std::function<void(const char*)> SetArrayName;
  std::function<std::string()> GetArrayName;
  std::string DefaultArrayName;

  vtkDataSet* GetOutput() const;
  vtkDataArray* GetValues() const;
};

/// One of each source, of some thousand points, and of the analytic source each field. New ones at
/// each call.
std::vector<TemporalSource> MakeTemporalSources();

/// Number of cells with a corner whose edges along i, j, k are not right-handed.
long long CountLeftHandedCells(vtkStructuredGrid* grid);

}

#endif
