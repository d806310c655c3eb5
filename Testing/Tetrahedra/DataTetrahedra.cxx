// SPDX-License-Identifier: BSD-3-Clause
#include "Tetrahedra/DataTetrahedra.h"

#include "Support/Inputs/DataFiles.h"
#include "Support/Inputs/ExodusTimeSource.h"
#include "Support/Images/CameraSettings.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <sstream>
#include <stdexcept>

namespace reference
{

namespace
{

vtkSmartPointer<vtkDataSet> Read(const std::string& file)
{
  const std::string exodus = ".ex2";
  if (file.size() < exodus.size() ||
    file.compare(file.size() - exodus.size(), exodus.size(), exodus) != 0)
  {
    return interlume::ReadData(file);
  }
  vtkNew<interlume::ExodusTimeSource> source;
  source->SetFileName(interlume::DataFile(file));
  source->UpdateTimeStep(1.0);
  return source->GetOutput();
}

}

std::string DataTetrahedra::GetName() const
{
  std::ostringstream name;
  name << this->File << ", " << this->Array;
  if (this->Lower < this->Upper)
  {
    name << " " << this->Lower << " to " << this->Upper;
  }
  return name.str();
}

ImageCase DataTetrahedra::Make(const std::array<int, 2>& size) const
{
  const vtkSmartPointer<vtkDataSet> data = Read(this->File);
  vtkDataArray* array = data->GetPointData()->GetArray(this->Array.c_str());
  if (!array)
  {
    throw std::runtime_error(this->File + " has no point array " + this->Array);
  }
  ImageCase what;
  double range[2] = { this->Lower, this->Upper };
  if (this->Lower < this->Upper)
  {
    vtkNew<vtkIntervalVolume> interval;
    interval->SetInputData(data);
    interval->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, this->Array.c_str());
    interval->SetInterval(0, this->Lower, this->Upper);
    interval->Update();
    what.Grid = vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(0));
  }
  else
  {
    vtkNew<vtkDataSetTriangleFilter> tetrahedra;
    tetrahedra->SetInputData(data);
    tetrahedra->TetrahedraOnlyOn();
    tetrahedra->Update();
    what.Grid = tetrahedra->GetOutput();
    array->GetRange(range);
  }
  what.Property = MakeProperty({ { range[0], { { 0.23, 0.3, 0.75 } }, 0.0 },
                                 { 0.5 * (range[0] + range[1]), { { 0.87, 0.87, 0.87 } }, 0.5 },
                                 { range[1], { { 0.7, 0.02, 0.15 } }, 1.0 } },
    what.Grid->GetLength() / 15.0);
  what.Settings.Size = size;
  what.Settings.Arrays.Scalars = this->Array;
  return what;
}

}
