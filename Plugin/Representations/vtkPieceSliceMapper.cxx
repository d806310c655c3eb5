// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPieceSliceMapper.h"

#include "vtkLightList.h"
#include "vtkExtinctionGrid.h"

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

/// Returns the brightest of the lights with a ShadowAttenuation above 0, at most \a number of them.
std::set<vtkLight*> FindShadowLights(const LightList& lights, int number)
{
  std::vector<vtkLight*> shadowLights;
  for (const auto& light : lights)
  {
    if (light->GetSwitch() && light->GetShadowAttenuation() > 0.0f)
    {
      shadowLights.push_back(light);
    }
  }
  const auto brightness = [](vtkLight* light)
  {
    const double* color = light->GetDiffuseColor();
    return light->GetIntensity() * *std::max_element(color, color + 3);
  };
  std::stable_sort(shadowLights.begin(), shadowLights.end(),
    [&](vtkLight* a, vtkLight* b) { return brightness(a) > brightness(b); });
  shadowLights.resize(std::min(shadowLights.size(), static_cast<std::size_t>(number)));
  return { shadowLights.begin(), shadowLights.end() };
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
  vtkExtinctionGrid::Piece piece;
  int isOfCells = 0;
  piece.Image = image && image->GetNumberOfPoints() > 0 ? image : nullptr;
  piece.Scalars = piece.Image ? vtkAbstractMapper::GetScalars(piece.Image, this->ScalarMode,
                                  this->ArrayAccessMode, this->ArrayId, this->ArrayName, isOfCells)
                              : nullptr;
  piece.IsOfCells = isOfCells == 1 || this->ScalarMode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  piece.Property = property;
  piece.IsColored = this->GetTransmissionColor() != nullptr;
  // All processes must use the same number of channels. A process without scalars has no
  // TransmissionColor.
  int needsColor = piece.IsColored ? 1 : 0;
  int isColored = 0;
  controller->AllReduce(&needsColor, &isColored, 1, vtkCommunicator::MAX_OP);
  piece.IsColored = isColored != 0;
  this->Grid = std::make_unique<vtkExtinctionGrid>();
  this->Grid->Gather(piece, resolution, controller);
}

void vtkPieceSliceMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* image = vtkImageData::SafeDownCast(this->GetDataObjectInput());
  if (!this->Grid || !this->Grid->HasMedium() || !this->GetShadows() || !image)
  {
    this->Lights.clear();
    this->Superclass::Render(renderer, volume);
    return;
  }
  const LightList lights = vtkLightList::Get(renderer);
  const std::set<vtkLight*> shadowLights =
    FindShadowLights(lights, this->GetMaximumNumberOfShadowLights());
  const std::array<double, 6> bounds = vtkExtinctionGrid::GetBounds(image);
  vtkNew<vtkMatrix4x4> worldFromAxes;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      worldFromAxes->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    }
  }
  vtkMatrix4x4::Multiply4x4(volume->GetMatrix(), worldFromAxes, worldFromAxes);
  LightList replacedLights;
  for (const auto& light : lights)
  {
    replacedLights.emplace_back(shadowLights.count(light) > 0
        ? this->Lights[light].Update(
            light, *this->Grid, this->Version, bounds.data(), worldFromAxes)
        : light.Get());
  }
  vtkLightList::Set(renderer, replacedLights);
  this->Superclass::Render(renderer, volume);
  vtkLightList::Set(renderer, lights);
}

void vtkPieceSliceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GridResolution: " << this->GridResolution << "\n";
  os << indent << "HasMediumOutside: " << (this->Grid && this->Grid->HasMedium()) << "\n";
}
