// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingRun_h
#define interlume_TimeVaryingRun_h

#include "Output/SizeWarning.h"
#include "Scalars/ExtractionValues.h"
#include "Static/EmptyOutputDiagnosis.h"
#include "Static/RefinementLevels.h"
#include "TimeVarying/TimeStep.h"
#include "TimeVarying/TimeVaryingMesh.h"
#include "TimeVarying/TimeVaryingReport.h"

#include "vtkSmartPointer.h"

#include <functional>
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
 * Stores a mesh and the previous step for each dataset of the input.
 */
class TimeVaryingRun
{
public:
  enum Results
  {
    DONE,
    /// The user aborted the run, or an error occurred.
    ABORTED,
    /// The input writes each step over the previous one. The run has to restart and copy the steps.
    OVERWRITTEN
  };

  /// Starts a run. \a steps are the indices of the steps to use, and \a times their times. \a
  /// sizeWarningLimit is a number of tetrahedra, or 0 for no warning. \a checkCriteria returns an
  /// error if the arrays of the criteria are invalid in a dataset. It is null if there are none.
  TimeVaryingRun(vtkAlgorithm* owner, const std::vector<vtkIntervalList::Interval>& intervals,
    const TimeVaryingOptions& options, const std::vector<int>& steps,
    const std::vector<double>& times, vtkIdType sizeWarningLimit,
    std::function<Error(vtkDataSet*)> checkCriteria = nullptr);

  bool IsFinished() const { return this->NextStep == static_cast<int>(this->Times.size()); }
  double GetNextTime() const { return this->Times[this->NextStep]; }

  /// Processes the next step. Returns an error if the step is invalid.
  Error AddStep(vtkDataObject* input, Results& result);

  /// Fills the outputs, which are unstructured grids or composite datasets with the structure of
  /// the input. Returns false if the user aborted.
  bool FillOutputs(vtkDataObject* tetrahedra, vtkDataObject* boundary, vtkDataObject* simplices);

  const TimeVaryingReport& GetReport() const { return this->Report; }

  /// Returns the warnings without duplicates.
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }

  /// Returns the object that explains an empty output. Call this after the last step.
  EmptyOutputDiagnosis& GetEmptyOutputDiagnosis() { return this->Empty; }

  /// Gives a composite output the block structure of the input.
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
    // Estimated number of tetrahedra of the slabs so far.
    double Tetrahedra = 0.0;
    // The key of the scalars (see ArrayMatch).
    std::string ScalarsKey;
  };

  ExtractionContext MakeContext();
  // Sets the progress range to the share that a leaf, in this part of a union, has in a range.
  void SetProgressRange(double begin, double end, std::size_t leaf);
  // Appends the other parts of a union to the outputs.
  bool AppendParts(const std::vector<vtkDataObject*>& outputs);
  /// Cuts the mesh at a criterion. Returns false if the user aborted, or if the array was skipped.
  bool ApplyCriterion(std::size_t number, TimeVaryingMesh& mesh);
  bool ApplyCriteria(TimeVaryingMesh& mesh);
  Error AddLeafStep(vtkDataSet* input, Leaf& leaf, std::size_t number, Results& result);
  void WarnAboutNonFinitePoints(const TimeStep& step, vtkDataSet* input);
  void UpdateEmptyDiagnosis();
  // Warns if the output will be large, judging by the slabs so far.
  void CheckSize();
  // Adds the estimated size of the last slab to \a size.
  void AddSize(SizeWarning::Size& size);
  // Returns the values of the intervals, or of the region outside of them.
  ExtractionValues MakeValues();
  /// Finds the scalars. If they are a cell array, sets \a input to a copy with the point array.
  Error FindScalars(vtkDataSet*& input, vtkDataArray*& scalars);
  std::string DescribeStep() const;
  // Stores a warning unless it is empty or already stored.
  void Warn(const std::string& what);

  vtkAlgorithm* Owner;
  CellArrayConversion Conversion;
  std::vector<vtkIntervalList::Interval> Intervals;
  TimeVaryingOptions Options;
  ExtractionValues Values;
  std::vector<int> Steps;
  std::vector<double> Times;
  SizeWarning Size;
  std::function<Error(vtkDataSet*)> CheckCriteria;
  TimeVaryingReport Report;
  // Number of 4-simplices that the diagnosis of an empty output knows.
  vtkIdType DiagnosedSimplices = 0;
  int NextStep = 0;
  // Number of folded cells of rectilinear grids, which the report includes in FoldedCells.
  vtkIdType FoldedInRows = 0;
  // If true, the previous slab had a nonzero duration, so the next slab shares points with it.
  bool IsJoined = false;
  std::vector<std::unique_ptr<Leaf>> Leaves;
  // The regions outside of the intervals that a union adds, one for each criterion.
  std::vector<std::unique_ptr<TimeVaryingRun>> Parts;
  EmptyOutputDiagnosis Empty;
  std::vector<std::string> Warnings;
  // If true, one of the warnings is about non-finite coordinates. Only the first such step is
  // reported.
  bool HasNonFiniteWarning = false;
};

}

#endif
