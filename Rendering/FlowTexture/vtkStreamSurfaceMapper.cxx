// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStreamSurfaceMapper.h"

#include "vtkStreamlineTexture.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>

vtkStandardNewMacro(vtkStreamSurfaceMapper);

vtkStreamSurfaceMapper::vtkStreamSurfaceMapper()
{
  this->TimelineTexture->SetDirection(vtkStreamlineTexture::T);
}

vtkStreamSurfaceMapper::~vtkStreamSurfaceMapper() = default;

vtkStreamlineTexture* vtkStreamSurfaceMapper::GetStreamlineTexture()
{
  return this->StreamlineTexture;
}

vtkStreamlineTexture* vtkStreamSurfaceMapper::GetTimelineTexture()
{
  return this->TimelineTexture;
}

std::vector<std::pair<vtkTexture*, std::string>> vtkStreamSurfaceMapper::GetLineTextures()
{
  std::vector<std::pair<vtkTexture*, std::string>> textures;
  if (this->Streamlines)
  {
    textures.emplace_back(this->StreamlineTexture, "streamlinesOfMapper");
  }
  if (this->Timelines)
  {
    textures.emplace_back(this->TimelineTexture, "timelinesOfMapper");
  }
  return textures;
}

std::vector<std::pair<vtkTexture*, std::string>> vtkStreamSurfaceMapper::GetTextures(
  vtkActor* actor)
{
  auto textures = this->Superclass::GetTextures(actor);
  if (this->HasCoordinates)
  {
    const auto lines = this->GetLineTextures();
    textures.insert(textures.end(), lines.begin(), lines.end());
  }
  return textures;
}

unsigned int vtkStreamSurfaceMapper::GetNumberOfTextures(vtkActor* actor)
{
  return static_cast<unsigned int>(this->GetTextures(actor).size());
}

bool vtkStreamSurfaceMapper::CheckCoordinates()
{
  if (vtkStreamlineTexture::HasCoordinates(this->CurrentInput, this->Timelines))
  {
    return true;
  }
  vtkDataArray* const coordinates = this->CurrentInput->GetPointData()->GetTCoords();
  const int components = coordinates ? coordinates->GetNumberOfComponents() : 0;
  const vtkMTimeType time = std::max(this->CurrentInput->GetMTime(), this->GetMTime());
  if (this->CurrentInput->GetNumberOfPoints() > 0 && this->FaultyTime != time)
  {
    this->FaultyTime = time;
    vtkErrorMacro(
      << (this->Timelines ? "Timelines need texture coordinates with two components"
                          : "Lines need texture coordinates with one or two components")
      << ", but the number of components is " << components
      << ". Use vtkStreamSurfaceParameters, or turn on ParametersAsTextureCoordinates of "
         "vtkFlowVolume.");
  }
  return false;
}

int vtkStreamSurfaceMapper::CanUseTextureMapForColoring(vtkDataObject* input)
{
  return this->GetLineTextures().empty() ? this->Superclass::CanUseTextureMapForColoring(input) : 0;
}

void vtkStreamSurfaceMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkStreamSurfaceMapper::SafeDownCast(mapper))
  {
    this->SetStreamlines(other->Streamlines);
    this->SetTimelines(other->Timelines);
    this->StreamlineTexture->CopySettings(other->StreamlineTexture);
    this->TimelineTexture->CopySettings(other->TimelineTexture);
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkStreamSurfaceMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  const auto lines = this->GetLineTextures();
  this->HasCoordinates = !lines.empty() && this->CheckCoordinates();
  for (const auto& [texture, name] : lines)
  {
    if (this->HasCoordinates)
    {
      texture->Render(renderer);
    }
  }
  this->Superclass::RenderPieceStart(renderer, actor);
}

void vtkStreamSurfaceMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  for (const auto& [texture, name] : this->GetLineTextures())
  {
    if (this->HasCoordinates)
    {
      texture->PostRender(renderer);
    }
  }
}

bool vtkStreamSurfaceMapper::HasOpaqueGeometry()
{
  return !this->HasTranslucentPolygonalGeometry() && this->Superclass::HasOpaqueGeometry();
}

bool vtkStreamSurfaceMapper::HasTranslucentPolygonalGeometry()
{
  const auto lines = this->GetLineTextures();
  return (!lines.empty() && lines.front().first->IsTranslucent() != 0) ||
    this->Superclass::HasTranslucentPolygonalGeometry();
}

void vtkStreamSurfaceMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->StreamlineTexture->ReleaseGraphicsResources(window);
  this->TimelineTexture->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkStreamSurfaceMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Streamlines: " << this->Streamlines << "\n";
  this->StreamlineTexture->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Timelines: " << this->Timelines << "\n";
  this->TimelineTexture->PrintSelf(os, indent.GetNextIndent());
}
