// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/SliceTextures.h"

#include "Loader/OpenGLFunctions.h"
#include "Shaders/SliceScattering.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeSamples.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkSliceMedium.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
void SetSampling(vtkTextureObject* texture, bool isSmooth)
{
  const int filter = isSmooth ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
}

int GetType(VolumeSamples::Formats format)
{
  switch (format)
  {
    case VolumeSamples::UNORM8:
      return VTK_UNSIGNED_CHAR;
    case VolumeSamples::UNORM16:
      return VTK_UNSIGNED_SHORT;
    default:
      return VTK_FLOAT;
  }
}

// Creates a texture with the size of \a samples. \a format is the internal format, or 0 for the
// default. Returns false on failure.
bool CreateVolume(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const VolumeSamples& samples, int components, int type, const void* values,
  unsigned int format = 0)
{
  texture->SetContext(window);
  SetSampling(texture, true);
  // Without this call, the texture would keep its previous format.
  texture->ResetFormatAndType();
  if (format != 0)
  {
    texture->SetInternalFormat(format);
  }
  return texture->Create3DFromRaw(static_cast<unsigned int>(samples.Size[0]),
    static_cast<unsigned int>(samples.Size[1]), static_cast<unsigned int>(samples.Size[2]),
    components, type, const_cast<void*>(values));
}

// Uploads a texture with the given number of columns. Releases the texture if \a texels is empty.
void UploadTable(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, int columns,
  const std::vector<float>& texels, int components)
{
  if (texels.empty())
  {
    texture->ReleaseGraphicsResources(window);
    return;
  }
  const std::size_t rows =
    texels.size() / (static_cast<std::size_t>(columns) * static_cast<std::size_t>(components));
  texture->SetContext(window);
  SetSampling(texture, false);
  // Without this call, the texture would keep its previous number of channels.
  texture->ResetFormatAndType();
  texture->Create2DFromRaw(static_cast<unsigned int>(columns), static_cast<unsigned int>(rows),
    components, VTK_FLOAT, const_cast<float*>(texels.data()));
}

using Edges = std::vector<std::array<float, 2>>;

// Returns, for each column, its value and the value of the next column, so that one lookup returns
// both. A column has \a stride values in \a table, of which the one at index \a first is used. If
// there are breakpoints between the two columns, the two values are replaced with the negative
// texel index of the list of breakpoints and the number of pieces. With \a edges, two more values,
// a scale and an offset, map a fraction f of the interval between the columns to the fraction
// scale * f + offset of the edge.
std::vector<float> MakePairs(const std::vector<float>& table, std::size_t first, std::size_t stride,
  const std::vector<int>& columnLists, const std::vector<float>& bends, const Edges* edges)
{
  std::vector<float> pairs;
  pairs.reserve((edges ? 4 : 2) * columnLists.size());
  for (std::size_t i = 0; i < columnLists.size(); ++i)
  {
    const bool isLast = (i + 1) % MaterialTable::Columns == 0;
    const std::size_t at = first + stride * i;
    const auto list = static_cast<std::size_t>(columnLists[i]);
    pairs.push_back(list > 0 ? -static_cast<float>(list) : table[at]);
    pairs.push_back(list > 0 ? bends[4 * list] : table[isLast ? at : at + stride]);
    if (edges)
    {
      // Width of an edge that is a step: the smallest that single precision resolves.
      constexpr float narrowest = 1e-5F;
      const std::array<float, 2>& edge = (*edges)[i];
      const float slope = 1.0F / std::max(edge[1] - edge[0], narrowest);
      pairs.push_back(slope);
      pairs.push_back(-edge[0] * slope);
    }
  }
  return pairs;
}

// Returns, for each column, red, green and blue, which are the first of its \a stride values in
// \a table, and the texel index of its list of breakpoints. If the color changes within an edge,
// the fourth value is negative and encodes the ends of the edge.
std::vector<float> MakeColors(const std::vector<float>& table, std::size_t stride,
  const std::vector<int>& bends, const Edges& edges)
{
  std::vector<float> colors;
  colors.reserve(4 * bends.size());
  for (std::size_t i = 0; i < bends.size(); ++i)
  {
    constexpr int edgePositions = TransferColumns::EdgePositions;
    const bool isEdge = edges[i][0] > 0.0F || edges[i][1] < 1.0F;
    const float edge = std::round(edges[i][0] * edgePositions) * (edgePositions + 1) +
      std::round(edges[i][1] * edgePositions);
    colors.insert(colors.end(), &table[stride * i], &table[stride * i] + 3);
    colors.push_back(isEdge ? -edge : static_cast<float>(bends[i]));
  }
  return colors;
}

// Returns the mean extinction between a column and the next.
double GetMean(const MaterialTable& material, std::size_t i, double value, double next)
{
  const auto list = static_cast<std::size_t>(material.ExtinctionBends[i]);
  if (list == 0)
  {
    const std::array<float, 2>& edge = material.ExtinctionEdges[i];
    return value * edge[0] + 0.5 * (value + next) * (edge[1] - edge[0]) + next * (1.0 - edge[1]);
  }
  double mean = 0.0;
  const auto pieces = static_cast<std::size_t>(material.Bends[4 * list]);
  for (std::size_t piece = list + 1; piece <= list + pieces; ++piece)
  {
    const float* ends = &material.Bends[4 * piece];
    mean += 0.5 * (static_cast<double>(ends[1]) - ends[0]) * (ends[2] + ends[3]);
  }
  return mean;
}

// Returns, for each column, the sums of the mean extinctions up to it and up to the next column,
// and the extinctions of both columns.
std::vector<float> MakeSums(const MaterialTable& material)
{
  std::vector<float> sums;
  sums.reserve(4 * material.ExtinctionBends.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < material.ExtinctionBends.size(); ++i)
  {
    const bool isLast = (i + 1) % MaterialTable::Columns == 0;
    const float extinction = material.Colors[4 * i + 3];
    const float nextExtinction = isLast ? extinction : material.Colors[4 * i + 7];
    const double next = isLast ? sum : sum + GetMean(material, i, extinction, nextExtinction);
    sums.insert(sums.end(),
      { static_cast<float>(sum), static_cast<float>(next), extinction, nextExtinction });
    sum = isLast ? 0.0 : next;
  }
  return sums;
}
}

SliceTextures::SliceTextures() = default;

SliceTextures::~SliceTextures() = default;

vtkIdType SliceTextures::GetBytes(const VolumeSamples& samples)
{
  const std::size_t bytes = samples.Texels.size() + samples.Mask.size() * sizeof(samples.Mask[0]);
  return static_cast<vtkIdType>(bytes);
}

vtkIdType SliceTextures::GetDifferenceBytes(const VolumeSamples& samples)
{
  // Four components, in half precision if texels are integers.
  const vtkIdType bytes = samples.Format == VolumeSamples::FLOAT32 ? 16 : 8;
  return bytes * samples.Size[0] * samples.Size[1] * samples.Size[2];
}

vtkIdType SliceTextures::GetBytes(const MaterialTable& material)
{
  // Count the values of colors, extinctions, gradient opacities, transmission colors and
  // breakpoints.
  const std::size_t pair = material.HasEdges() ? 4 : 2;
  const std::size_t values = 4 * material.ColorBends.size() +
    pair * (material.ExtinctionBends.size() + material.GradientOpacityBends.size()) +
    4 * material.TransmissionBends.size() + material.Bends.size();
  return static_cast<vtkIdType>(sizeof(float)) * static_cast<vtkIdType>(values);
}

vtkIdType SliceTextures::GetBytes(const SliceScattering& scattering)
{
  return static_cast<vtkIdType>(sizeof(float)) *
    static_cast<vtkIdType>(scattering.Phases.size() + scattering.Texels.size());
}

Error SliceTextures::Upload(vtkOpenGLRenderWindow* window, const VolumeSamples& samples)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
  const int largest = *std::max_element(samples.Size.begin(), samples.Size.end());
  if (largest > limit)
  {
    return Error("The volume has " + std::to_string(largest) +
        " samples along an axis, but 3D textures are limited to " + std::to_string(limit) +
        ". Resample the volume.",
      ErrorCode::OpenGL);
  }
  ClearOpenGLErrors();
  bool isCreated = CreateVolume(window, this->Volume, samples, samples.Components,
    GetType(samples.Format), samples.Texels.data());
  if (samples.Mask.empty())
  {
    this->Mask->ReleaseGraphicsResources(window);
  }
  else
  {
    isCreated = isCreated &&
      CreateVolume(window, this->Mask, samples, 1, VTK_UNSIGNED_SHORT, samples.Mask.data());
  }
  if (!isCreated || glGetError() != GL_NO_ERROR)
  {
    this->Volume->ReleaseGraphicsResources(window);
    this->Mask->ReleaseGraphicsResources(window);
    return Error("The graphics card does not have enough memory for the volume's textures (" +
        std::to_string(GetBytes(samples)) + " bytes). Use a smaller volume.",
      ErrorCode::OutOfMemory);
  }
  return {};
}

Error SliceTextures::UploadDifferences(vtkOpenGLRenderWindow* window, const VolumeSamples* samples)
{
  this->Differences->ReleaseGraphicsResources(window);
  if (!samples)
  {
    return {};
  }
  ClearOpenGLErrors();
  const std::vector<float> differences = samples->FindDifferences();
  const bool isFloat = samples->Format == VolumeSamples::FLOAT32;
  return CreateVolume(window, this->Differences, *samples, 3, VTK_FLOAT, differences.data(),
           isFloat ? GL_RGBA32F : GL_RGBA16F) &&
      glGetError() == GL_NO_ERROR
    ? Error()
    : Error("There is not enough memory for the gradients of the volume (" +
          std::to_string(GetDifferenceBytes(*samples)) + " bytes). Use a smaller volume.",
        ErrorCode::OutOfMemory);
}

Error SliceTextures::Upload(vtkOpenGLRenderWindow* window, const MaterialTable& material)
{
  ClearOpenGLErrors();
  constexpr int columns = MaterialTable::Columns;
  const bool hasEdges = material.HasEdges();
  const int pair = hasEdges ? 4 : 2;
  UploadTable(window, this->Colors, columns,
    MakeColors(material.Colors, 4, material.ColorBends, material.ColorEdges), 4);
  UploadTable(window, this->Extinctions, columns,
    MakePairs(material.Colors, 3, 4, material.ExtinctionBends, material.Bends,
      hasEdges ? &material.ExtinctionEdges : nullptr),
    pair);
  UploadTable(window, this->GradientOpacities, columns,
    MakePairs(material.GradientOpacity, 0, 1, material.GradientOpacityBends, material.Bends,
      hasEdges ? &material.GradientOpacityEdges : nullptr),
    pair);
  UploadTable(window, this->Transmissions, columns,
    MakeColors(material.Transmission, 3, material.TransmissionBends, material.TransmissionEdges),
    4);
  std::vector<float> bends = material.Bends;
  const std::size_t row = 4 * columns;
  bends.resize((bends.size() + row - 1) / row * row, 0.0F);
  UploadTable(window, this->Bends, columns, bends, 4);
  // Only the shaders that draw thick fragments or integrate spans use the sums. Activate uploads
  // them on demand.
  this->ExtinctionSums->ReleaseGraphicsResources(window);
  this->SumTexels = MakeSums(material);
  return glGetError() == GL_NO_ERROR
    ? Error()
    : Error("The graphics card does not have enough memory for the transfer functions.",
        ErrorCode::OutOfMemory);
}

Error SliceTextures::Upload(vtkOpenGLRenderWindow* window, const SliceScattering& scattering)
{
  ClearOpenGLErrors();
  UploadTable(window, this->Phases, SliceScattering::PhaseColumns, scattering.Phases, 1);
  if (scattering.Texels.empty())
  {
    this->Scattered->ReleaseGraphicsResources(window);
  }
  else
  {
    const glm::ivec3 size = scattering.GetTextureSize();
    GLint limit = 0;
    glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &limit);
    if (size.z > limit)
    {
      return "Scattered light needs " + std::to_string(size.z) +
        " samples along an axis, but 3D textures are limited to " + std::to_string(limit) +
        ". Use a smaller ScatteringGridSize or fewer lights.";
    }
    this->Scattered->SetContext(window);
    SetSampling(this->Scattered, true);
    this->Scattered->ResetFormatAndType();
    this->Scattered->Create3DFromRaw(static_cast<unsigned int>(size.x),
      static_cast<unsigned int>(size.y), static_cast<unsigned int>(size.z), 4, VTK_FLOAT,
      const_cast<float*>(scattering.Texels.data()));
  }
  return glGetError() == GL_NO_ERROR
    ? Error()
    : Error("The graphics card does not have enough memory for the scattered light (" +
          std::to_string(GetBytes(scattering)) + " bytes). Use a smaller ScatteringGridSize.",
        ErrorCode::OutOfMemory);
}

void SliceTextures::Activate(vtkShaderProgram* program)
{
  if (!this->SumTexels.empty() && program->IsUniformUsed("extinctionSums"))
  {
    UploadTable(this->Extinctions->GetContext(), this->ExtinctionSums, MaterialTable::Columns,
      this->SumTexels, 4);
    this->SumTexels.clear();
  }
  const auto activate = [&](vtkTextureObject* texture, const char* name)
  {
    if (texture->GetHandle() && program->IsUniformUsed(name))
    {
      texture->Activate();
      program->SetUniformi(name, texture->GetTextureUnit());
      const std::pair<vtkTextureObject*, int> bound(texture, texture->GetTextureUnit());
      const auto known = std::find_if(this->Active.begin(), this->Active.end(),
        [&bound](const auto& other) { return other.first == bound.first; });
      if (known == this->Active.end())
      {
        this->Active.push_back(bound);
      }
      else
      {
        *known = bound;
      }
    }
  };
  activate(this->Volume, "volume");
  activate(this->Mask, "mask");
  activate(this->Differences, "neighborDifferences");
  activate(this->Extinctions, "extinctions");
  activate(this->ExtinctionSums, "extinctionSums");
  activate(this->Colors, "colors");
  activate(this->GradientOpacities, "gradientOpacities");
  activate(this->Transmissions, "transmissions");
  activate(this->Bends, "bends");
  activate(this->Phases, "phases");
  activate(this->Scattered, "scattered");
  if (this->Medium)
  {
    this->Medium->Activate(program);
  }
}

void SliceTextures::Deactivate()
{
  this->Suspend();
  this->Active.clear();
}

void SliceTextures::Suspend()
{
  for (const auto& bound : this->Active)
  {
    bound.first->Deactivate();
  }
  if (this->Medium)
  {
    this->Medium->Deactivate();
  }
}

bool SliceTextures::Resume()
{
  // A custom medium may use other texture units now, so its uniforms must be set again.
  bool isSame = this->Medium == nullptr;
  for (const auto& bound : this->Active)
  {
    bound.first->Activate();
    isSame = isSame && bound.first->GetTextureUnit() == bound.second;
  }
  return isSame;
}

void SliceTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextureObject* texture :
    { this->Volume.Get(), this->Mask.Get(), this->Differences.Get(), this->Colors.Get(),
      this->Extinctions.Get(), this->ExtinctionSums.Get(), this->GradientOpacities.Get(),
      this->Transmissions.Get(), this->Bends.Get(), this->Phases.Get(), this->Scattered.Get() })
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Screens.Keep({}, window);
}

}
