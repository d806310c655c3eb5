// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Meshes/ReferenceImageSource.h"

#include "Support/Checks/ReferenceExecution.h"

#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>

namespace reference
{

namespace
{

void CheckPart(vtkImageAlgorithm* source, vtkImageData* complete, const int extent[6], Check& check)
{
  source->Modified();
  source->UpdateExtent(extent);
  vtkNew<vtkImageData> expected;
  expected->DeepCopy(complete);
  expected->Crop(extent);
  check.That(std::equal(extent, extent + 6, source->GetOutput()->GetExtent()),
    "the output has the requested extent");
  check.That(!GetBytes(expected).empty() && GetBytes(source->GetOutput()) == GetBytes(expected),
    "part of the image equals the complete image bit by bit");
}

// Requests a block, and single layers of points perpendicular to each axis.
void CheckParts(vtkImageAlgorithm* source, Check& check)
{
  source->UpdateWholeExtent();
  vtkNew<vtkImageData> complete;
  complete->DeepCopy(source->GetOutput());
  const int* all = complete->GetExtent();
  const int block[6] = { all[0] + 2, all[1] - 3, all[2] + 1, all[2] + 1, all[4], all[5] - 1 };
  CheckPart(source, complete, block, check);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int layer = all[2 * axis]; layer <= all[2 * axis + 1]; layer += 2)
    {
      int extent[6];
      std::copy_n(all, 6, extent);
      extent[2 * axis] = layer;
      extent[2 * axis + 1] = layer;
      CheckPart(source, complete, extent, check);
    }
  }
}

void CheckNumbersOfThreads(vtkImageAlgorithm* source, Check& check)
{
  vtkSMPTools::SetBackend("STDThread");
  std::string expected;
  for (int threads : { 1, 2, 8 })
  {
    SetThreads(threads);
    source->Modified();
    source->UpdateWholeExtent();
    const std::string bytes = GetBytes(source->GetOutput());
    if (threads == 1)
    {
      expected = bytes;
    }
    check.That(!bytes.empty() && bytes == expected,
      "the bytes are the same with " + std::to_string(threads) + " threads");
  }
}

void CheckAbort(vtkImageAlgorithm* source, Check& check)
{
  const auto update = [source]()
  {
    source->UpdateWholeExtent();
    return GetBytes(source->GetOutput());
  };
  CheckAborts(source, 5, { 0.0, 0.3, 0.6 }, update, check);
}

}

std::string GetBytes(vtkImageData* image)
{
  vtkDataArray* array = image->GetPointData()->GetScalars();
  array = array ? array : image->GetPointData()->GetVectors();
  return array ? std::string(static_cast<const char*>(array->GetVoidPointer(0)),
                   array->GetNumberOfValues() * array->GetDataTypeSize())
               : std::string();
}

void CheckImageSource(vtkImageAlgorithm* source, Check& check)
{
  CheckParts(source, check);
  CheckNumbersOfThreads(source, check);
  CheckAbort(source, check);
}

}
