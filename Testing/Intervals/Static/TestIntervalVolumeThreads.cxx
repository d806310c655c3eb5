// SPDX-License-Identifier: BSD-3-Clause
// Output is bit-identical for 1, 2 and 8 threads and every backend.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkImageData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

void CheckForm(const DataSetVariant& form, Check& check)
{
  CheckThreads(
    form.Name,
    [&form]
    {
      const Extraction intervals = ExtractIntervals(form.Data, { { 0.2, 0.4 }, { 0.4, 0.7 } });
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ intervals.Volume, intervals.Surface,
        ExtractContours(form.Data, { 0.3, 0.8 }).Surface };
    },
    check);
}

}

int TestIntervalVolumeThreads(int, char*[])
{
  Check check;
  auto image = MakeImage({ 24, 20, 16 });
  AddRandomField(image, 5);
  for (const DataSetVariant& form : FormsOf(image))
  {
    CheckForm(form, check);
  }
  for (MeshKind kind : { MeshKind::Mixed, MeshKind::Kelvin })
  {
    auto mesh = MakeMesh(kind, { 10, 10, 10 });
    AddRandomField(mesh, 5);
    CheckForm({ GetName(kind), mesh }, check);
  }
  return check.Result();
}
