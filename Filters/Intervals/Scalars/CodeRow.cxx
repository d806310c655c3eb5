// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/CodeRow.h"

#include "Scalars/ExtractionKernels.h"
#include "Scalars/RowKernels.h"

#include <algorithm>

namespace interlume
{

void CodeRow::Fill(
  const ExtractionScalars& scalars, vtkIdType row, vtkIdType point, vtkIdType number, Code* codes)
{
  this->Row = row;
  this->Codes = codes;
  this->IsFinite = scalars.Classify(point, number, codes);
  ExtractionKernels::FindVaryingRange(codes, number, this->First, this->Last);
  // It suffices to read the varying codes and one of the equal codes at each end.
  const vtkIdType begin = this->First - 1;
  const vtkIdType end = std::max(std::min<vtkIdType>(this->Last + 2, number), begin + 1);
  Code ties;
  RowKernels::Summarize(codes + begin, end - begin, this->Minimum, this->Maximum, ties);
  this->HasTies = ExtractionValues::IsTie(ties);
}

}
