// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPieceSliceMapper.h"

#include "vtkLightList.h"
#include "vtkMatterGrid.h"

#include "vtkCommunicator.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkPieceSliceMapper);

namespace
{
using LightList = std::vector<vtkSmartPointer<vtkLight>>;

/// Returns the lights that cast shadows: the brightest of those that can.
std::set<vtkLight*> FindShadowed(const LightList& lights, int number)
{
  std::vector<vtkLight*> shadowed;
  for (const auto& light : lights)
  {
    if (light->GetSwitch() && light->GetShadowAttenuation() > 0.0f)
    {
      shadowed.push_back(light);
    }
  }
  const auto brightness = [](vtkLight* light)
  {
    const double* color = light->GetDiffuseColor();
    return light->GetIntensity() * *std::max_element(color, color + 3);
  };
  std::stable_sort(shadowed.begin(), shadowed.end(),
    [&](vtkLight* a, vtkLight* b) { return brightness(a) > brightness(b); });
  shadowed.resize(std::min(shadowed.size(), static_cast<std::size_t>(number)));
  return { shadowed.begin(), shadowed.end() };
}
}

vtkPieceSliceMapper::vtkPieceSliceMapper() = default;

vtkPieceSliceMapper::~vtkPieceSliceMapper() = default;

void vtkPieceSliceMapper::GatherPieces(
  vtkVolumeProperty* property, int resolution, vtkMultiProcessController* controller)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataObjectInput());
  const vtkMTimeType time =
    std::max({ image ? image->GetMTime() : 0, property->GetMTime(), this->GetMTime() });
  int isNew = time > this->GridTime || resolution != this->GridResolution ? 1 : 0;
  int isAnyNew = 0;
  controller->AllReduce(&isNew, &isAnyNew, 1, vtkCommunicator::MAX_OP);
  if (isAnyNew == 0)
  {
    return;
  }
  this->GridTime = time;
  this->GridResolution = resolution;
  ++this->Version;
  this->Grid.reset();
  if (resolution <= 0)
  {
    return;
  }
  vtkMatterGrid::Piece piece;
  int isOfCells = 0;
  piece.Image = image && image->GetNumberOfPoints() > 0 ? image : nullptr;
  piece.Scalars = piece.Image ? vtkAbstractMapper::GetScalars(piece.Image, this->ScalarMode,
                                  this->ArrayAccessMode, this->ArrayId, this->ArrayName, isOfCells)
                              : nullptr;
  piece.IsOfCells = isOfCells == 1 || this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  piece.Property = property;
  piece.IsColored = this->GetTransmissionColor() != nullptr;
  // Where one process has no scalars to choose by, all have as many channels as those that have.
  int wantsColors = piece.IsColored ? 1 : 0;
  int isColored = 0;
  controller->AllReduce(&wantsColors, &isColored, 1, vtkCommunicator::MAX_OP);
  piece.IsColored = isColored != 0;
  this->Grid = std::make_unique<vtkMatterGrid>();
  this->Grid->Gather(piece, resolution, controller);
}

void vtkPieceSliceMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataObjectInput());
  if (!this->Grid || !this->Grid->HasMatter() || !this->GetShadows() || !image)
  {
    this->Lights.clear();
    this->Superclass::Render(renderer, volume);
    return;
  }
  const LightList lights = vtkLightList::Get(renderer);
  const std::set<vtkLight*> shadowed = FindShadowed(lights, this->GetMaximumNumberOfShadows());
  const std::array<double, 6> bounds = vtkMatterGrid::GetBounds(image);
  vtkNew<vtkMatrix4x4> worldFromAxes;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      worldFromAxes->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    }
  }
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), worldFromAxes, worldFromAxes);
  LightList reaching;
  for (const auto& light : lights)
  {
    reaching.emplace_back(shadowed.count(light) > 0 ? this->Lights[light].Update(light, *this->Grid,
                                                        this->Version, bounds.data(), worldFromAxes)
                                                    : light.Get());
  }
  vtkLightList::Set(renderer, reaching);
  this->Superclass::Render(renderer, volume);
  vtkLightList::Set(renderer, lights);
}

void vtkPieceSliceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GridResolution: " << this->GridResolution << "\n";
  os << indent << "HasOutsideMatter: " << (this->Grid && this->Grid->HasMatter()) << "\n";
}
