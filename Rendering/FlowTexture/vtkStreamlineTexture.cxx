// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStreamlineTexture.h"

#include "Loader/OpenGLFunctions.h"
#include "Stripes/StripePyramid.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkStreamlineTexture);

namespace
{
constexpr int MaximumLines = 4096;
}

vtkStreamlineTexture::vtkStreamlineTexture()
{
  this->RepeatOn();
  this->InterpolateOn();
  this->MipmapOn();
}

void vtkStreamlineTexture::SetNumberOfLines(int number)
{
  if (number < 1 || number > MaximumLines || (number & (number - 1)) != 0)
  {
    vtkErrorMacro("NumberOfLines " << number << " is not a power of two from 1 to " << MaximumLines
                                   << " and was ignored.");
    return;
  }
  if (this->NumberOfLines != number)
  {
    this->NumberOfLines = number;
    this->Modified();
  }
}

void vtkStreamlineTexture::SetOffset(double offset)
{
  if (!std::isfinite(offset))
  {
    vtkErrorMacro("Offset " << offset << " is not finite and was ignored.");
    return;
  }
  if (this->Offset != offset)
  {
    this->Offset = offset;
    this->Modified();
  }
}

int vtkStreamlineTexture::GetNumberOfLevels() const
{
  interlume::StripePyramid pyramid;
  pyramid.NumberOfLines = this->NumberOfLines;
  return pyramid.GetNumberOfLevels();
}

int vtkStreamlineTexture::IsTranslucent()
{
  return this->BackgroundColor[3] < 1.0 ? 1 : 0;
}

void vtkStreamlineTexture::AddTo(vtkActor* actor, vtkStreamlineTexture* streamlines,
  vtkStreamlineTexture* timelines, vtkTexture* below)
{
  vtkTexture* lowest = below;
  const std::array<std::pair<const char*, vtkStreamlineTexture*>, 2> lines = { {
    { "streamlines", streamlines },
    { "timelines", timelines },
  } };
  for (const auto& [name, texture] : lines)
  {
    actor->GetProperty()->RemoveTexture(name);
    if (texture && lowest)
    {
      actor->GetProperty()->SetTexture(name, texture);
    }
    else if (texture)
    {
      lowest = texture;
    }
  }
  actor->SetTexture(lowest);
}

bool vtkStreamlineTexture::HasCoordinates(vtkDataSet* surface, bool hasTimelines)
{
  vtkDataArray* const coordinates = surface->GetPointData()->GetTCoords();
  const int components = coordinates ? coordinates->GetNumberOfComponents() : 0;
  return components == 2 || (components == 1 && !hasTimelines);
}

void vtkStreamlineTexture::CopySettings(vtkStreamlineTexture* other)
{
  this->SetDirection(other->Direction);
  this->SetNumberOfLines(other->NumberOfLines);
  this->SetLineWidth(other->LineWidth);
  this->SetOffset(other->Offset);
  this->SetTexelsPerLine(other->TexelsPerLine);
  this->SetLineColor(other->LineColor);
  this->SetBackgroundColor(other->BackgroundColor);
}

void vtkStreamlineTexture::Render(vtkRenderer* renderer)
{
  this->Load(renderer);
}

void vtkStreamlineTexture::Load(vtkRenderer* renderer)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("The renderer has no vtkOpenGLRenderWindow. Add the renderer to one.");
    return;
  }
  const bool isOther = this->RenderWindow != window;
  if (isOther && this->TextureObject)
  {
    this->ReleaseGraphicsResources(this->RenderWindow);
  }
  if (isOther || !this->TextureObject || this->GetMTime() > this->LoadTime)
  {
    this->RenderWindow = window;
    if (!this->TextureObject)
    {
      this->TextureObject = vtkTextureObject::New();
    }
    this->TextureObject->SetContext(window);
    this->BlendingMode = this->IsTranslucent() ? VTK_TEXTURE_BLENDING_MODE_REPLACE
                                               : VTK_TEXTURE_BLENDING_MODE_MODULATE;
    this->Upload();
    this->LoadTime.Modified();
  }
  this->TextureObject->Activate();
}

void vtkStreamlineTexture::Upload()
{
  interlume::StripePyramid pyramid;
  pyramid.NumberOfLines = this->NumberOfLines;
  pyramid.TexelsPerLine = this->TexelsPerLine;
  pyramid.LineWidth = this->LineWidth;
  pyramid.Offset = this->Offset;
  std::copy_n(this->LineColor, 3, pyramid.Line.begin());
  std::copy_n(this->BackgroundColor, 4, pyramid.Background.begin());
  GLint longest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
  while (pyramid.GetLength(0) > longest && pyramid.NumberOfLines > 1)
  {
    pyramid.NumberOfLines /= 2;
  }
  const std::pair<int, int> size(this->NumberOfLines, this->TexelsPerLine);
  if (pyramid.NumberOfLines != this->NumberOfLines && this->TooLarge != size)
  {
    this->TooLarge = size;
    vtkErrorMacro("OpenGL's maximum texture size does not allow "
      << this->NumberOfLines << " lines of " << this->TexelsPerLine
      << " texels. The texture has only " << pyramid.NumberOfLines
      << " lines. Reduce NumberOfLines or TexelsPerLine.");
  }
  const int levels = pyramid.GetNumberOfLevels();
  vtkTextureObject* texture = this->TextureObject;
  texture->SetWrapS(vtkTextureObject::Repeat);
  texture->SetWrapT(vtkTextureObject::Repeat);
  texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetMaximumAnisotropicFiltering(1.0f);
  texture->SetBaseLevel(0);
  texture->SetMaxLevel(levels - 1);
  const bool isAlongT = this->Direction == T;
  for (int level = 0; level < levels; ++level)
  {
    std::vector<unsigned char> texels = pyramid.GetTexels(level);
    const int length = pyramid.GetLength(level);
    const int width = isAlongT ? 1 : length;
    const int height = isAlongT ? length : 1;
    if (level == 0)
    {
      texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
        4, VTK_UNSIGNED_CHAR, texels.data());
      texture->Activate();
    }
    else
    {
      glTexImage2D(
        GL_TEXTURE_2D, level, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    }
  }
  texture->Deactivate();
  ++this->NumberOfUploads;
}

void vtkStreamlineTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Direction: " << (this->Direction == T ? "T" : "S") << "\n";
  os << indent << "NumberOfLines: " << this->NumberOfLines << "\n";
  os << indent << "LineWidth: " << this->LineWidth << "\n";
  os << indent << "Offset: " << this->Offset << "\n";
  os << indent << "TexelsPerLine: " << this->TexelsPerLine << "\n";
  os << indent << "LineColor: " << this->LineColor[0] << " " << this->LineColor[1] << " "
     << this->LineColor[2] << "\n";
  os << indent << "BackgroundColor: " << this->BackgroundColor[0] << " " << this->BackgroundColor[1]
     << " " << this->BackgroundColor[2] << " " << this->BackgroundColor[3] << "\n";
  os << indent << "NumberOfUploads: " << this->NumberOfUploads << "\n";
}
