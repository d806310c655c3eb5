// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInflowTextureRepresentation.h"

#include "vtkTextureImage.h"

#include "vtkImageData.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

vtkStandardNewMacro(vtkInflowTextureRepresentation);

namespace
{
/// Returns an image of colored squares, or bands across u, with transparent gaps of the same size.
vtkSmartPointer<vtkImageData> CreatePattern(bool isCheckerboard)
{
  constexpr int fields = 8;
  constexpr int texels = 32;
  constexpr int size = fields * texels;
  constexpr unsigned char colors[4][3] = { { 230, 85, 45 }, { 245, 190, 60 }, { 60, 160, 110 },
    { 50, 105, 190 } };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int v = 0; v < size; ++v)
  {
    for (int u = 0; u < size; ++u, texel += 4)
    {
      const int column = u / texels;
      const int row = isCheckerboard ? v / texels : 0;
      std::copy_n(colors[(isCheckerboard ? row : column) / 2], 3, texel);
      texel[3] = (column + row) % 2 == 0 ? 255 : 0;
    }
  }
  return image;
}
}

vtkInflowTextureRepresentation::vtkInflowTextureRepresentation()
{
  this->SetMapper(vtkNew<vtkImplicitFlowVolumeMapper>());
  this->SetOpacityRange(0.0, 1.0);
}

vtkInflowTextureRepresentation::~vtkInflowTextureRepresentation() = default;

void vtkInflowTextureRepresentation::SetMapper(vtkImplicitFlowVolumeMapper* mapper)
{
  this->Mapper = mapper;
  this->VolumeMapper = mapper;
}

void vtkInflowTextureRepresentation::SetInflowTexture(vtkTexture* texture)
{
  this->InflowTexture = texture;
}

void vtkInflowTextureRepresentation::SetInflowPattern(int pattern)
{
  const int clamped = std::clamp<int>(pattern, NO_PATTERN, BANDS);
  if (clamped != this->InflowPattern)
  {
    this->InflowPattern = clamped;
    this->PatternImage = clamped == NO_PATTERN ? nullptr : CreatePattern(clamped == CHECKERBOARD);
  }
}

void vtkInflowTextureRepresentation::SetSurfaceTexture(vtkTexture* texture)
{
  this->SurfaceTexture = texture;
}

void vtkInflowTextureRepresentation::SetSurfaceId(int id)
{
  this->Mapper->SetInflowTexture(this->SurfaceId, nullptr);
  this->SurfaceId = std::max(id, 0);
}

void vtkInflowTextureRepresentation::SetDetailTexture(vtkTexture* texture)
{
  this->DetailTexture = texture;
}

void vtkInflowTextureRepresentation::SetDefaultColor(double red, double green, double blue)
{
  this->Mapper->SetDefaultColor(red, green, blue, this->Mapper->GetDefaultColor()[3]);
}

void vtkInflowTextureRepresentation::SetDefaultOpacity(double opacity)
{
  const double* color = this->Mapper->GetDefaultColor();
  this->Mapper->SetDefaultColor(color[0], color[1], color[2], opacity);
}

void vtkInflowTextureRepresentation::SetPulseLength(double fraction)
{
  const double end = std::clamp(fraction, 0.0, 1.0);
  this->Gate->RemoveAllPoints();
  // A sharpness of 1 makes the function piecewise constant.
  this->Gate->AddPoint(0.0, end > 0.0 ? 1.0 : 0.0, 0.0, 1.0);
  this->Gate->AddPoint(end, end > 0.0 ? 1.0 : 0.0, 0.0, 1.0);
  this->Gate->AddPoint(1.0, 0.0);
  this->Mapper->SetTimeGate(end < 1.0 ? this->Gate.Get() : nullptr);
}

void vtkInflowTextureRepresentation::SetUseOpacityArray(bool use)
{
  this->UseOpacityArray = use;
}

void vtkInflowTextureRepresentation::SelectInflowOpacityArray(int, int, int, int, const char* name)
{
  this->OpacityArray = name ? name : "";
}

void vtkInflowTextureRepresentation::SetOpacityRange(double from, double to)
{
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(from, 0.0);
  this->Opacity->AddPoint(to, 1.0);
}

void vtkInflowTextureRepresentation::SelectShadingArray(int, int, int, int, const char* name)
{
  this->Mapper->SetShadingArray(name);
}

int vtkInflowTextureRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = GetInput(inputVector);
  auto* image = vtkImageData::SafeDownCast(input);
  if (image && image->GetPointData()->GetNumberOfArrays() == 0)
  {
    vtkErrorMacro("The image has no point arrays. Inflow Textures requires the arrays that the "
                  "Implicit Flow Field filter generates, such as TerminationUV. Apply that filter "
                  "first, with its Sample Mode set to Image.");
  }
  if (!input || image)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  vtkErrorMacro("Inflow Textures requires an image, but the input is a "
    << input->GetClassName()
    << ". Set the Sample Mode of the Implicit Flow Field filter to Image.");
  return this->RequestDataOf(vtkNew<vtkImageData>(), request, inputVector, outputVector);
}

void vtkInflowTextureRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  // The superclass renders nothing unless the mapper has a valid array. This mapper finds its
  // arrays by name and reports missing ones, so select any array.
  this->Mapper->SetScalarModeToUsePointFieldData();
  this->Mapper->SelectScalarArray(0);
  // The superclass hides the actor if there is no color array.
  this->Actor->SetVisibility(this->GetVisibility());
  this->Mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL,
    this->InflowTexture ? vtkTextureImage(this->InflowTexture) : this->PatternImage.Get());
  this->Mapper->SetInflowTexture(this->SurfaceId, vtkTextureImage(this->SurfaceTexture));
  this->Mapper->SetDetailTexture(vtkTextureImage(this->DetailTexture));
  this->Mapper->SetOpacityArray(this->UseOpacityArray ? this->OpacityArray.c_str() : nullptr);
  this->Property->SetScalarOpacity(this->Opacity);
}

void vtkInflowTextureRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceId: " << this->SurfaceId << "\n";
  os << indent << "InflowPattern: " << this->InflowPattern << "\n";
  os << indent << "UseOpacityArray: " << this->UseOpacityArray << "\n";
  os << indent << "OpacityArray: " << this->OpacityArray << "\n";
  os << indent << "OpacityRange: " << this->Opacity->GetRange()[0] << ", "
     << this->Opacity->GetRange()[1] << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}
