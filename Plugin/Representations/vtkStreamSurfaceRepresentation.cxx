// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStreamSurfaceRepresentation.h"

#include "vtkStreamlineTexture.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkTexture.h"

#include <algorithm>

vtkStandardNewMacro(vtkStreamSurfaceRepresentation);

namespace
{
/// Returns whether all blocks with points have texture coordinates for lines.
bool HasLineCoordinates(vtkDataObject* surfaces, bool hasTimelines)
{
  const std::vector<vtkDataSet*> blocks = vtkCompositeDataSet::GetDataSets(surfaces);
  return std::all_of(blocks.begin(), blocks.end(),
    [hasTimelines](vtkDataSet* block)
    {
      return block->GetNumberOfPoints() == 0 ||
        vtkStreamlineTexture::HasCoordinates(block, hasTimelines);
    });
}
}

vtkStreamSurfaceRepresentation::vtkStreamSurfaceRepresentation() = default;

vtkStreamSurfaceRepresentation::~vtkStreamSurfaceRepresentation() = default;

void vtkStreamSurfaceRepresentation::SetStreamlines(bool on)
{
  this->Streamlines = on;
  this->UpdateTextures();
}

void vtkStreamSurfaceRepresentation::SetTimelines(bool on)
{
  this->Timelines = on;
  this->UpdateTextures();
}

void vtkStreamSurfaceRepresentation::SetStreamlineTexture(vtkStreamlineTexture* texture)
{
  this->StreamlineTexture = texture;
  this->UpdateTextures();
}

void vtkStreamSurfaceRepresentation::SetTimelineTexture(vtkStreamlineTexture* texture)
{
  this->TimelineTexture = texture;
  if (texture)
  {
    texture->SetDirection(vtkStreamlineTexture::T);
  }
  this->UpdateTextures();
}

void vtkStreamSurfaceRepresentation::SetTexture(vtkTexture* image)
{
  this->Superclass::SetTexture(image);
  this->Image = image;
  this->UpdateTextures();
}

void vtkStreamSurfaceRepresentation::SetInterpolateScalarsBeforeMapping(int on)
{
  this->InterpolatesScalars = on;
  this->UpdateTextures();
}

void vtkStreamSurfaceRepresentation::UpdateTextures()
{
  // VTK would use the coordinates of the colors for the lines.
  const bool hasLines = this->HasCoordinates && (this->Streamlines || this->Timelines);
  this->Superclass::SetInterpolateScalarsBeforeMapping(hasLines ? 0 : this->InterpolatesScalars);
  vtkStreamlineTexture::AddTo(this->Actor,
    this->Streamlines && this->HasCoordinates ? this->StreamlineTexture : nullptr,
    this->Timelines && this->HasCoordinates ? this->TimelineTexture : nullptr, this->Image);
}

void vtkStreamSurfaceRepresentation::UpdateColoringParameters()
{
  this->Superclass::UpdateColoringParameters();
  // The mapper has the data of the next image. On a client, no other function sees them.
  vtkDataObject* const surfaces = this->Mapper->GetInputDataObject(0, 0);
  if (!surfaces || (!this->Streamlines && !this->Timelines))
  {
    return;
  }
  const bool hasCoordinates = HasLineCoordinates(surfaces, this->Timelines);
  if (this->HasCoordinates && !hasCoordinates)
  {
    vtkErrorMacro(
      "Lines need texture coordinates with two components, or one for streamlines, but "
      "the data have none. Apply \"Stream Surface Parameters\", or turn on \"Parameters As Texture "
      "Coordinates\" of \"Flow Volume\".");
  }
  if (this->HasCoordinates != hasCoordinates)
  {
    this->HasCoordinates = hasCoordinates;
    this->UpdateTextures();
  }
}

void vtkStreamSurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Streamlines: " << this->Streamlines << "\n";
  os << indent << "Timelines: " << this->Timelines << "\n";
}
