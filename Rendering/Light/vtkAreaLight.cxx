// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLight.h"

#include "Common/NamedValue.h"
#include "Lights/EmitterGrid.h"
#include "Lights/EmitterSamples.h"
#include "Lights/LightFrame.h"
#include "Lights/LightImage.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAreaLight);

namespace
{
constexpr double MaximumSize = 1e30;
}

vtkAreaLight::vtkAreaLight() = default;
vtkAreaLight::~vtkAreaLight() = default;

void vtkAreaLight::SetShape(int shape)
{
  if (shape != ROUND && shape != SQUARE)
  {
    vtkErrorMacro("Shape " << shape << " is invalid and was ignored. Use ROUND (0) or SQUARE (1).");
    return;
  }
  if (this->Shape != shape)
  {
    this->Shape = shape;
    this->Grid = nullptr;
    this->Modified();
  }
}

const char* vtkAreaLight::GetShapeAsString() const
{
  return this->Shape == ROUND ? "Round" : "Square";
}

void vtkAreaLight::SetSize(double width, double height)
{
  if (!(width >= 0.0 && width <= MaximumSize && height >= 0.0 && height <= MaximumSize))
  {
    vtkErrorMacro("Size (" << width << ", " << height
                           << ") is out of range and was ignored. Both values must be from 0 to "
                           << MaximumSize << ".");
    return;
  }
  if (this->Size[0] != width || this->Size[1] != height)
  {
    this->Size[0] = width;
    this->Size[1] = height;
    this->Modified();
  }
}

void vtkAreaLight::SetEmitter(vtkImageData* image)
{
  if (this->Emitter != image)
  {
    this->Emitter = image;
    this->Grid = nullptr;
    this->Modified();
  }
}

vtkImageData* vtkAreaLight::GetEmitter() const
{
  return this->Emitter;
}

void vtkAreaLight::SetViewUp(double x, double y, double z)
{
  if (!interlume::LightFrame::IsFinite({ x, y, z }))
  {
    vtkErrorMacro("ViewUp (" << x << ", " << y << ", " << z << ") is not finite and was ignored.");
    return;
  }
  if (interlume::LightFrame::SetViewUp(this->ViewUp, { x, y, z }))
  {
    this->Modified();
  }
}

bool vtkAreaLight::GetFrame(interlume::LightFrame& frame)
{
  double position[3];
  double focalPoint[3];
  double viewUp[3];
  this->GetTransformedPosition(position);
  this->GetTransformedFocalPoint(focalPoint);
  this->TransformVector(this->ViewUp, viewUp);
  return frame.Set(position, focalPoint, viewUp);
}

bool vtkAreaLight::GetCenter(double center[3])
{
  interlume::LightFrame frame;
  const bool isFrame = this->GetFrame(frame);
  std::copy_n(glm::value_ptr(frame.Origin), 3, center);
  return isFrame;
}

bool vtkAreaLight::GetNormal(double normal[3])
{
  interlume::LightFrame frame;
  const bool isFrame = this->GetFrame(frame);
  std::copy_n(glm::value_ptr(frame.Forward), 3, normal);
  return isFrame;
}

bool vtkAreaLight::GetEmitterMatrix(vtkMatrix4x4* matrix)
{
  interlume::LightFrame frame;
  if (!this->GetFrame(frame))
  {
    return false;
  }
  const glm::dvec3 columns[4] = { frame.Right, frame.Up, -frame.Forward, frame.Origin };
  matrix->Identity();
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      matrix->SetElement(row, column, columns[column][row]);
    }
  }
  return true;
}

const interlume::EmitterGrid* vtkAreaLight::GetGrid() const
{
  if (!this->Emitter)
  {
    return nullptr;
  }
  const vtkMTimeType time = this->Emitter->GetMTime();
  if (!this->Grid || this->GridTime != time)
  {
    this->Grid = std::make_unique<interlume::EmitterGrid>(this->Shape == ROUND, this->Emitter);
    this->GridTime = time;
  }
  return this->Grid.get();
}

std::string vtkAreaLight::GetEmitterError() const
{
  return this->Emitter
    ? interlume::LightImage(this->Emitter).GetError("the image of its emitter").GetMessage()
    : "";
}

std::vector<vtkAreaLight::Sample> vtkAreaLight::GetSamples(int count)
{
  std::vector<Sample> samples;
  interlume::LightFrame frame;
  if (!this->GetFrame(frame) || !this->GetEmitterError().empty())
  {
    return samples;
  }
  for (const interlume::EmitterSamples::Sample& source :
    interlume::EmitterSamples::Make(this->Shape == ROUND, this->GetGrid(), count))
  {
    const glm::dvec3 position = frame.Origin + source.Position.x * this->Size[0] * frame.Right +
      source.Position.y * this->Size[1] * frame.Up;
    Sample sample;
    std::copy_n(glm::value_ptr(position), 3, sample.Position);
    std::copy_n(glm::value_ptr(source.Weight), 3, sample.Weight);
    samples.push_back(sample);
  }
  return samples;
}

void vtkAreaLight::GetEmitterColor(double color[3]) const
{
  const interlume::EmitterGrid* grid = this->GetEmitterError().empty() ? this->GetGrid() : nullptr;
  const glm::dvec3 mean = grid ? grid->GetColor() : glm::dvec3(1.0);
  std::copy_n(glm::value_ptr(mean), 3, color);
}

vtkMTimeType vtkAreaLight::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Emitter ? std::max(time, this->Emitter->GetMTime()) : time;
}

void vtkAreaLight::DeepCopy(vtkLight* light)
{
  this->Superclass::DeepCopy(light);
  this->SetTransformMatrix(light->GetTransformMatrix());
  this->SetShadowAttenuation(light->GetShadowAttenuation());
  if (auto* area = vtkAreaLight::SafeDownCast(light))
  {
    this->SetShape(area->Shape);
    this->SetSize(area->Size);
    this->SetEmitter(area->Emitter);
    this->SetViewUp(area->ViewUp);
  }
}

vtkLight* vtkAreaLight::ShallowClone()
{
  vtkAreaLight* clone = vtkAreaLight::New();
  clone->DeepCopy(this);
  return clone;
}

void vtkAreaLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Shape", this->GetShapeAsString() }, { "Size", this->Size },
      { "Emitter", this->Emitter.GetPointer() }, { "ViewUp", this->ViewUp } });
}
