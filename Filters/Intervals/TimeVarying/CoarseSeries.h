// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CoarseSeries_h
#define interlume_CoarseSeries_h

#include "TimeVarying/TimeVaryingRun.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataObject;

namespace interlume
{

/**
 * @class   CoarseSeries
 * @brief   coarse copies of the time steps of an input, for previews
 *
 * The copies have fewer steps, and structured grids have fewer points (see GridSampling). They are
 * kept, so that further previews do not request the steps again.
 */
class CoarseSeries
{
public:
  /// State that the copies depend on.
  struct Key
  {
    /// Modification time of the input's pipeline.
    vtkMTimeType InputTime = 0;
    /// Indices of the selected steps.
    std::vector<int> Steps;
    /// Number of cells times number of slabs that the copies have at most, if possible.
    vtkIdType Limit = 0;
    /// Piece, number of pieces and ghost levels.
    std::array<int, 3> Piece{ { 0, 1, 0 } };

    bool operator==(const Key& other) const
    {
      return this->InputTime == other.InputTime && this->Steps == other.Steps &&
        this->Limit == other.Limit && this->Piece == other.Piece;
    }
  };

  /// Starts a preview. Returns true if there are copies of all steps for \a key; otherwise removes
  /// all copies.
  bool Begin(const Key& key);

  /// Chooses the strides in time and in space for the cells of a step.
  void ChooseStrides(vtkDataObject* input);

  /// Returns the number of selected steps per step of the copies.
  int GetTimeStride() const { return this->TimeStride; }

  /// Adds a copy of \a input to \a run. If all copies exist, adds them instead.
  Error AddStep(vtkDataObject* input, TimeVaryingRun& run, TimeVaryingRun::Results& result);

private:
  bool IsComplete() const { return this->Steps.size() == this->GetNumberOfSteps(); }
  std::size_t GetNumberOfSteps() const;

  Key State;
  int TimeStride = 1;
  int Stride = 1;
  std::vector<vtkSmartPointer<vtkDataObject>> Steps;
};

}

#endif
