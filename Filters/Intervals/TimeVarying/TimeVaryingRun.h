// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingRun_h
#define interlume_TimeVaryingRun_h

#include "Scalars/ExtractionValues.h"
#include "Static/EmptyResult.h"
#include "Static/RefinementLevels.h"
#include "TimeVarying/TimeStep.h"
#include "TimeVarying/TimeVaryingMesh.h"
#include "TimeVarying/TimeVaryingReport.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace interlume
{

/**
 * @class   TimeVaryingRun
 * @brief   one execution of vtkTimeVaryingIntervalVolume, step by step
 *
 * Holds a mesh and the step before for each dataset of the input.
 */
class TimeVaryingRun
{
public:
  enum Results
  {
    DONE,
    /// The user ended the run, or there is an error.
    ABORTED,
    /// The input writes each step over the one before, so that the run has to begin anew, with
    /// copies.
    OVERWRITTEN
  };

  /// Begins a run. \a times are those of the steps to be taken, of which the first is step \a
  /// firstStep of the input.
  TimeVaryingRun(vtkAlgorithm* owner, const ArrayFinder& findArray,
    const std::vector<vtkIntervalList::Interval>& intervals, const TimeVaryingOptions& options,
    int firstStep, const std::vector<double>& times);

  bool IsFinished() const { return this->NextStep == static_cast<int>(this->Times.size()); }
  double GetNextTime() const { return this->Times[this->NextStep]; }

  /// Takes the next step. Returns an error if it cannot be used.
  Error AddStep(vtkDataObject* input, Results& result);

  /// Fills unstructured grids or composite datasets of the input's structure. Returns false when
  /// the user aborted.
  bool FillOutputs(vtkDataObject* tetrahedra, vtkDataObject* boundary, vtkDataObject* simplices);

  const TimeVaryingReport& GetReport() const { return this->Report; }

  /// Returns the warnings, each once.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// Returns the object that says why there is nothing, once all steps are taken.
  EmptyResult& GetEmptyResult() { return this->Empty; }

  /// Gives a composite output the blocks of its input.
  static void CopyStructure(vtkDataObject* input, vtkDataObject* output);

private:
  // The state of one dataset of the input.
  struct Leaf
  {
    explicit Leaf(const TimeVaryingOptions& options)
      : Mesh(options)
    {
    }
    std::unique_ptr<TimeStep> Before;
    TimeVaryingMesh Mesh;
    // The key of the scalars, see ArrayMatch.
    std::string ScalarsKey;
  };

  ExtractionContext MakeContext();
  Error AddLeafStep(vtkDataSet* input, Leaf& leaf, std::size_t number, Results& result);
  void WarnOfNonFinite(const TimeStep& step, vtkDataSet* input);
  void NoteEmptiness();
  Error CheckScalars(vtkDataSet* input, vtkDataArray*& scalars) const;
  std::string DescribeStep() const;
  // Keeps a warning, unless it is empty or there already.
  void Warn(const std::string& what);

  vtkAlgorithm* Owner;
  ArrayFinder FindArray;
  std::vector<vtkIntervalList::Interval> Intervals;
  ExtractionValues Values;
  TimeVaryingOptions Options;
  int FirstStep;
  std::vector<double> Times;
  TimeVaryingReport Report;
  int NextStep = 0;
  // The cells of the report's FoldedCells that are of rectilinear grids.
  vtkIdType FoldedInRows = 0;
  // Whether the slab before had a duration, so that this one is joined to it.
  bool IsJoined = false;
  std::vector<std::unique_ptr<Leaf>> Leaves;
  EmptyResult Empty;
  std::vector<std::string> Warnings;
  // Whether one of them is about non-finite coordinates: the first step that has some is named.
  bool HasNonFiniteWarning = false;
};

}

#endif
