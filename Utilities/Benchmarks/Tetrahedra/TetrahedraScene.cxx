// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "Benchmarks/Data/AnalyticCases.h"
#include "Benchmarks/Data/CellSplits.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"

#include <algorithm>

namespace tetrahedra
{
namespace
{
const AnalyticCase& GetGyroid()
{
  static const AnalyticCase gyroid = []()
  {
    const std::vector<AnalyticCase> cases = MakeAnalyticCases();
    return *std::find_if(
      cases.begin(), cases.end(), [](const AnalyticCase& one) { return one.Name == "gyroid"; });
  }();
  return gyroid;
}
}

double GetField(double x, double y, double z)
{
  return GetGyroid().Field(x, y, z);
}

double GetLow()
{
  return GetGyroid().Low;
}

double GetHigh()
{
  return GetGyroid().High;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(int cubes)
{
  auto grid = SplitIntoTetrahedra(GetGyroid().Sample(cubes + 1), 5);
  constexpr int layers = 4;
  const vtkIdType cells = grid->GetNumberOfCells();
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("IntervalId");
  numbers->SetNumberOfValues(cells);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    numbers->SetValue(cell, static_cast<int>(layers * cell / cells));
  }
  grid->GetCellData()->AddArray(numbers);
  return grid;
}

vtkSmartPointer<vtkVolumeProperty> MakeProperty()
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(-1.5, 0.1, 0.2, 0.8);
  color->AddRGBPoint(-0.2, 0.8, 0.8, 0.8);
  color->AddRGBPoint(1.5, 0.9, 0.2, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(-1.5, 0.4);
  opacity->AddPoint(-0.2, 0.02);
  opacity->AddPoint(1.5, 0.9);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.5);
  property->SetInterpolationTypeToLinear();
  return property;
}

vtkSmartPointer<vtkCamera> MakeCamera()
{
  const double center = 0.5 * (GetLow() + GetHigh());
  const double edge = GetHigh() - GetLow();
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(center, center, center);
  camera->SetPosition(center + 1.1 * edge, center + 0.9 * edge, center + 2.6 * edge);
  camera->SetViewAngle(30.0);
  camera->SetClippingRange(1.0 * edge, 5.0 * edge);
  return camera;
}

SharedStage::SharedStage(int pixels)
  : Size({ { pixels, pixels } })
  , Stage(this->Size)
  , Property(MakeProperty())
  , Camera(MakeCamera())
{
}

BenchWork SharedStage::MakeRenderWork(vtkUnstructuredGridVolumeMapper* mapper)
{
  return [this, mapper]()
  {
    this->Stage.SetVolume(mapper, this->Property);
    vtkNew<vtkCamera> moved;
    moved->DeepCopy(this->Camera);
    moved->Azimuth(0.5 * (++this->Frames % 40));
    this->Stage.SetCamera(moved);
    this->Stage.Render();
    return vtkSmartPointer<vtkObjectBase>(mapper);
  };
}

reference::RgbaImage SharedStage::Capture(vtkUnstructuredGridVolumeMapper* mapper)
{
  this->Stage.SetVolume(mapper, this->Property);
  this->Stage.SetCamera(this->Camera);
  return this->Stage.Capture(2);
}

reference::RgbaImage SharedStage::CaptureSeparately(vtkUnstructuredGridVolumeMapper* mapper) const
{
  reference::VolumeStage stage(this->Size);
  stage.SetVolume(mapper, this->Property);
  stage.SetCamera(this->Camera);
  return stage.Capture(2);
}
}
