// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SeriesEstimate_h
#define interlume_SeriesEstimate_h

#include "Common/CellArrayConversion.h"
#include "Scalars/ExtractionValues.h"
#include "Static/RefinementLevels.h"
#include "TimeVarying/TimeVaryingOptions.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <map>
#include <vector>

class vtkDataObject;

namespace interlume
{

struct Blanking;

/**
 * @class   SeriesEstimate
 * @brief   estimates the number of tetrahedra of a time series from a sample of cells and steps
 *
 * The sample consists of evenly spaced cells. Slabs between two steps are extracted from the sample
 * and scaled to all cells. The sampled slabs are spread evenly over the series, and their distances
 * (the number of steps between their ends) are 1, 2, 4, ... . Between these distances, the size of
 * a slab is interpolated linearly.
 */
class SeriesEstimate
{
public:
  /// Reads a time step. Returns null if it is not available.
  using StepReader = std::function<vtkDataObject*(int step)>;

  /// \a times are the times of all steps that may be used. Steps are counted from the first of
  /// them. \a owner is the filter whose array is processed.
  SeriesEstimate(vtkAlgorithm* owner, const std::vector<vtkIntervalList::Interval>& intervals,
    const vtkTimeVaryingSettings& settings, const std::vector<double>& times);

  /// Reads the steps needed for slabs of the given distances, and estimates the sizes of these
  /// slabs. Returns false if a step cannot be read or differs from the others in its cells.
  bool Read(const std::vector<int>& distances, const StepReader& read);

  /// Returns the number of tetrahedra of the slab that starts at a step. \a distance must be one of
  /// those passed to Read().
  double GetSlabSize(int distance, int step) const;

  /// Returns the estimated number of tetrahedra if every \a stride -th step is used.
  double GetSize(int stride) const;

  int GetLastStep() const { return static_cast<int>(this->Times.size()) - 1; }

private:
  struct Pair
  {
    int First;
    int Second;
  };

  std::vector<Pair> FindPairs(int distance) const;
  void SampleCells(const std::vector<vtkDataSet*>& leaves);
  void SampleCell(vtkDataSet* leaf, vtkIdType cell, const Blanking& blanking);
  bool SampleValues(int step, const std::vector<vtkDataSet*>& leaves);
  double CountTetrahedra(const Pair& slab) const;

  CellArrayConversion Conversion;
  std::vector<vtkIntervalList::Interval> Intervals;
  vtkTimeVaryingSettings Settings;
  std::vector<double> Times;
  // The sampled cells of all leaves, which share no points, and the number of cells that each of
  // them represents. Points that move stay at their positions of the step that was read first.
  vtkNew<vtkUnstructuredGrid> Cells;
  double CellsPerSample = 1.0;
  // For each leaf, the point ids of the sampled cells.
  std::vector<std::vector<vtkIdType>> Points;
  // The values at the points of the sampled cells, by step.
  std::map<int, vtkSmartPointer<vtkDoubleArray>> Values;
  // The sizes of the sampled slabs, by distance and first step, and their means, by distance.
  std::map<int, std::map<int, double>> SlabSizes;
  std::map<int, double> MeanSizes;
};

}

#endif
