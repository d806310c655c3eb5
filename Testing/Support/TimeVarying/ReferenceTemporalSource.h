// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceTemporalSource_h
#define ReferenceTemporalSource_h

#include "vtkAlgorithm.h"    // for the source
#include "vtkSmartPointer.h" // for the source

#include <functional> // for the common methods
#include <string>     // for the names
#include <vector>     // for the sources

class vtkDataArray;
class vtkDataSet;
class vtkStructuredGrid;

/**
 * Common interface of the temporal sources under test, which have no common base class.
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

/// Returns new sources with a few thousand points each: one for each field of
/// vtkAnalyticFieldSource, and one of each other source class.
std::vector<TemporalSource> MakeTemporalSources();

/// Returns the number of cells with a corner whose edges along i, j, k are not right-handed.
long long CountLeftHandedCells(vtkStructuredGrid* grid);

}

#endif
