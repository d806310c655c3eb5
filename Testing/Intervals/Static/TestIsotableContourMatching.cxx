// SPDX-License-Identifier: BSD-3-Clause
// Documented guarantees for contours with values equal to the isovalue: no triangle occurs twice or
// with both orientations, edges match, and the contour bounds the interval above it. Tested with
// all 8-bit data files and with small integers in every cell type.
#include "Support/Inputs/DataFiles.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Intervals/ReferenceMatching.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

void CheckVolume(const std::string& file, Check& check)
{
  check.SetContext(file);
  const auto crop = CropVolume(*interlume::ReadData(file), 16, 0);
  const std::vector<double> bounds = GetQuantiles(*crop);
  for (size_t i = 1; i < bounds.size(); ++i)
  {
    CheckMatchingContour(crop, bounds[i], check);
  }
}

void CheckKind(MeshKind kind, Check& check)
{
  for (int values : { 2, 3, 5 })
  {
    for (unsigned int seed = 3; seed <= 6; ++seed)
    {
      check.SetContext(
        GetName(kind) + ", " + std::to_string(values) + " values, seed " + std::to_string(seed));
      auto mesh =
        RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
      AddIntegerField(mesh, values, seed);
      for (int value = 1; value < values; ++value)
      {
        CheckMatchingContour(mesh, value, check);
      }
    }
  }
}

/// Two voxels with a common face at the isovalue and lower values elsewhere have an empty contour.
void CheckPlateau(Check& check)
{
  check.SetContext("plateau");
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 2);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    image->GetPointData()->GetScalars()->SetComponent(p, 0, p % 3 == 1 ? 7 : 3);
  }
  check.Equal(ExtractContours(image, { 7, 5 }).Surface->GetNumberOfCells(), 4,
    "triangles of 5, on both sides of the plateau at 7");
}

}

int TestIsotableContourMatching(int, char*[])
{
  Check check;
  for (const std::string& file : GetTiedVolumeFileNames())
  {
    CheckVolume(file, check);
  }
  for (MeshKind kind : AllMeshKinds())
  {
    CheckKind(kind, check);
  }
  CheckPlateau(check);
  return check.Result();
}
