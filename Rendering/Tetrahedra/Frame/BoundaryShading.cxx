// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/BoundaryShading.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace interlume
{

namespace
{
glm::dvec3 Normalized(const glm::dvec3& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : v;
}

// A row or column of pixels of a mipmap level, and its weight in one of the next level.
struct PixelWeight
{
  int Pixel;
  float Weight;
};

// Returns the rows or columns that row or column \a i of the next level covers. The two levels have
// \a before and \a after of them.
std::vector<PixelWeight> FindWeights(int i, int before, int after)
{
  const double size = static_cast<double>(before) / after;
  std::vector<PixelWeight> weights;
  for (int p = static_cast<int>(i * size); p < before && p < (i + 1) * size; ++p)
  {
    const double covered = std::min(p + 1.0, (i + 1) * size) - std::max<double>(p, i * size);
    weights.push_back({ p, static_cast<float>(covered / size) });
  }
  return weights;
}

// Returns the mean color of pixels, weighted by opacity.
BoundaryShading::Color GetMean(const BoundaryShading::Color* pixels, int width,
  const std::vector<PixelWeight>& columns, const std::vector<PixelWeight>& rows)
{
  BoundaryShading::Color sum{};
  for (const PixelWeight& row : rows)
  {
    for (const PixelWeight& column : columns)
    {
      const BoundaryShading::Color& pixel =
        pixels[static_cast<std::size_t>(row.Pixel) * width + column.Pixel];
      const float weight = row.Weight * column.Weight;
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += weight * pixel[3] * pixel[c];
      }
      sum[3] += weight * pixel[3];
    }
  }
  for (int c = 0; c < 3 && sum[3] > 0.0f; ++c)
  {
    sum[c] /= sum[3];
  }
  return sum;
}

// Appends the mipmap levels to an image, and returns their number with that of the image.
int AppendLevels(int width, int height, std::vector<BoundaryShading::Color>& pixels)
{
  int levels = 1;
  for (std::size_t first = 0; width > 1 || height > 1; ++levels)
  {
    const int nextWidth = std::max(width / 2, 1);
    const int nextHeight = std::max(height / 2, 1);
    std::vector<std::vector<PixelWeight>> columns;
    for (int x = 0; x < nextWidth; ++x)
    {
      columns.push_back(FindWeights(x, width, nextWidth));
    }
    for (int y = 0; y < nextHeight; ++y)
    {
      const std::vector<PixelWeight> rows = FindWeights(y, height, nextHeight);
      for (const std::vector<PixelWeight>& column : columns)
      {
        pixels.push_back(GetMean(&pixels[first], width, column, rows));
      }
    }
    first += static_cast<std::size_t>(width) * height;
    width = nextWidth;
    height = nextHeight;
  }
  return levels;
}

}

void BoundaryShading::Set(
  vtkRenderer* renderer, const TetrahedraView& view, const std::vector<Source>& materials)
{
  const std::vector<int> images = this->SetImages(materials);
  this->Materials.resize(materials.size());
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    vtkProperty* property = materials[i].Property;
    Material& material = this->Materials[i];
    material.Base[3] = static_cast<float>(property->GetOpacity());
    for (int c = 0; c < 3; ++c)
    {
      material.Base[c] = static_cast<float>(property->GetDiffuseColor()[c]);
      material.SpecularColor[c] = static_cast<float>(property->GetSpecularColor()[c]);
    }
    const bool isLit = property->GetLighting();
    material.Coefficients = { { static_cast<float>(isLit ? property->GetAmbient() : 1.0),
      static_cast<float>(isLit ? property->GetDiffuse() : 0.0),
      static_cast<float>(isLit ? property->GetSpecular() : 0.0),
      static_cast<float>(property->GetSpecularPower()) } };
    material.Texture = images[i];
  }
  this->SetLights(renderer, view);

  // Cofactors transform normals: they equal the inverse transpose up to a factor.
  const std::array<double, 12>& m = view.GetEyeFromMesh();
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const int i1 = (i + 1) % 3;
      const int i2 = (i + 2) % 3;
      const int j1 = (j + 1) % 3;
      const int j2 = (j + 2) % 3;
      this->NormalMatrix[3 * i + j] =
        static_cast<float>(m[4 * i1 + j1] * m[4 * i2 + j2] - m[4 * i1 + j2] * m[4 * i2 + j1]);
    }
  }
}

std::vector<int> BoundaryShading::SetImages(const std::vector<Source>& materials)
{
  std::map<vtkTexture*, int> known;
  std::vector<int> indices;
  std::vector<vtkTexture*> textures;
  for (const Source& material : materials)
  {
    const auto entry = known.emplace(material.Texture, static_cast<int>(textures.size()));
    if (entry.second && material.Texture)
    {
      textures.push_back(material.Texture);
    }
    indices.push_back(material.Texture ? entry.first->second : -1);
  }
  this->Images.resize(textures.size());
  for (std::size_t i = 0; i < textures.size(); ++i)
  {
    this->Images[i].Set(textures[i]);
  }
  for (int& index : indices)
  {
    const bool isEmpty = index >= 0 && this->Images[static_cast<std::size_t>(index)].IsEmpty();
    index = isEmpty ? -1 : index;
  }
  return indices;
}

void BoundaryShading::SetLights(vtkRenderer* renderer, const TetrahedraView& view)
{
  this->Lights.clear();
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    if (!light->GetSwitch() || static_cast<int>(this->Lights.size()) == MAXIMUM_LIGHTS)
    {
      continue;
    }
    double position[4] = { 0.0, 0.0, 0.0, 1.0 };
    double focus[4] = { 0.0, 0.0, 0.0, 1.0 };
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focus);
    const glm::dvec3 eyePosition = view.GetEyeFromWorld(glm::make_vec4(position));
    const glm::dvec3 toward = Normalized(eyePosition - view.GetEyeFromWorld(glm::make_vec4(focus)));
    Light eyeLight;
    eyeLight.IsPositional = light->GetPositional() != 0;
    eyeLight.Position = glm::vec3(eyeLight.IsPositional ? eyePosition : toward);
    for (int c = 0; c < 3; ++c)
    {
      eyeLight.Color[c] = static_cast<float>(light->GetDiffuseColor()[c] * light->GetIntensity());
    }
    this->Lights.push_back(eyeLight);
  }
}

void BoundaryShading::Image::Set(vtkTexture* texture)
{
  if (texture && texture->GetInputAlgorithm())
  {
    texture->GetInputAlgorithm()->Update();
  }
  vtkImageData* input = texture ? texture->GetInput() : nullptr;
  vtkDataArray* scalars = input ? input->GetPointData()->GetScalars() : nullptr;
  int dimensions[3] = { 0, 0, 0 };
  if (input)
  {
    input->GetDimensions(dimensions);
  }
  const vtkIdType size = static_cast<vtkIdType>(dimensions[0]) * dimensions[1];
  if (!scalars || scalars->GetNumberOfTuples() < size)
  {
    *this = Image();
    return;
  }
  this->Repeated = texture->GetRepeat() != 0;
  vtkMTimeType time = std::max(input->GetMTime(), texture->GetMTime());
  if (texture->GetLookupTable())
  {
    time = std::max(time, texture->GetLookupTable()->GetMTime());
  }
  if (time == this->Time)
  {
    return;
  }
  this->Time = time;
  this->Width = dimensions[0];
  this->Height = dimensions[1];
  const bool isColor =
    vtkUnsignedCharArray::SafeDownCast(scalars) && scalars->GetNumberOfComponents() <= 4;
  // Arrays other than colors are mapped through the lookup table of the texture.
  unsigned char* mapped = isColor ? nullptr : texture->MapScalarsToColors(scalars);
  const int components = isColor ? scalars->GetNumberOfComponents() : 4;
  const auto pixels = static_cast<std::size_t>(this->Width) * this->Height;
  auto image = std::make_shared<std::vector<Color>>(pixels, Color{ { 0.0f, 0.0f, 0.0f, 1.0f } });
  for (std::size_t i = 0; i < pixels; ++i)
  {
    const auto get = [&](int c)
    {
      const double value =
        mapped ? mapped[4 * i + c] : scalars->GetComponent(static_cast<vtkIdType>(i), c);
      return static_cast<float>(value / 255.0);
    };
    // One component is gray, two are gray and opacity.
    for (int c = 0; c < 3; ++c)
    {
      (*image)[i][c] = get(components >= 3 ? c : 0);
    }
    if (components == 2 || components == 4)
    {
      (*image)[i][3] = get(components - 1);
    }
  }
  this->NumberOfLevels = texture->GetMipmap() ? AppendLevels(this->Width, this->Height, *image) : 1;
  this->Pixels = image;
}

BoundaryShading::Image::Level BoundaryShading::Image::GetLevel(int number) const
{
  Level level{ 0, this->Width, this->Height };
  for (int i = 0; i < number; ++i)
  {
    level.First += static_cast<std::size_t>(level.Width) * level.Height;
    level.Width = std::max(level.Width / 2, 1);
    level.Height = std::max(level.Height / 2, 1);
  }
  return level;
}

BoundaryShading::Color BoundaryShading::Image::Sample(const TexturePosition& position) const
{
  if (this->NumberOfLevels == 1)
  {
    return this->SampleLevel(this->GetLevel(0), position.At);
  }
  const glm::dvec2 size(this->Width, this->Height);
  const double step =
    std::max(glm::length(position.ChangeX * size), glm::length(position.ChangeY * size));
  const double level =
    step > 1.0 ? std::min(std::log2(step), static_cast<double>(this->NumberOfLevels - 1)) : 0.0;
  const int lower = static_cast<int>(level);
  Color color = this->SampleLevel(this->GetLevel(lower), position.At);
  const auto share = static_cast<float>(level - lower);
  if (share > 0.0f)
  {
    const Color next = this->SampleLevel(this->GetLevel(lower + 1), position.At);
    for (int c = 0; c < 4; ++c)
    {
      color[c] += share * (next[c] - color[c]);
    }
  }
  return color;
}

BoundaryShading::Color BoundaryShading::Image::SampleLevel(
  const Level& level, const glm::dvec2& at) const
{
  // Bilinear interpolation between texel centers.
  const auto position = [this](double t, int size, int ends[2])
  {
    t = std::isfinite(t) ? t : 0.0;
    t = this->Repeated ? t - std::floor(t) : std::max(0.0, std::min(t, 1.0));
    const double coordinate = t * size - 0.5;
    const double first = std::floor(coordinate);
    for (int i = 0; i < 2; ++i)
    {
      const int pixel = static_cast<int>(first) + i;
      ends[i] = this->Repeated ? (pixel + size) % size : std::max(0, std::min(pixel, size - 1));
    }
    return static_cast<float>(coordinate - first);
  };
  int x[2];
  int y[2];
  const float a = position(at[0], level.Width, x);
  const float b = position(at[1], level.Height, y);
  const auto pixel = [&](int i, int j) -> const Color&
  { return (*this->Pixels)[level.First + static_cast<std::size_t>(y[j]) * level.Width + x[i]]; };
  Color color;
  for (int c = 0; c < 4; ++c)
  {
    const float low = pixel(0, 0)[c] + a * (pixel(1, 0)[c] - pixel(0, 0)[c]);
    const float high = pixel(0, 1)[c] + a * (pixel(1, 1)[c] - pixel(0, 1)[c]);
    color[c] = low + b * (high - low);
  }
  return color;
}

BoundaryShading::Color BoundaryShading::Shade(const Material& material, const glm::dvec3& eye,
  const glm::dvec3& normal, const TexturePosition& texturePosition) const
{
  Color base = material.Base;
  if (material.Texture >= 0)
  {
    const Color texel =
      this->Images[static_cast<std::size_t>(material.Texture)].Sample(texturePosition);
    for (int c = 0; c < 4; ++c)
    {
      base[c] *= texel[c];
    }
  }
  glm::dvec3 n;
  for (int i = 0; i < 3; ++i)
  {
    n[i] = this->NormalMatrix[3 * i] * normal[0] + this->NormalMatrix[3 * i + 1] * normal[1] +
      this->NormalMatrix[3 * i + 2] * normal[2];
  }
  n = Normalized(n);
  const glm::dvec3 view = Normalized(-eye);
  if (glm::dot(n, view) < 0.0)
  {
    n = -n;
  }
  Color color;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = base[c] * material.Coefficients[0];
  }
  for (const Light& light : this->Lights)
  {
    const glm::dvec3 position(light.Position);
    const glm::dvec3 toward = Normalized(light.IsPositional ? position - eye : position);
    const double cosine = glm::dot(n, toward);
    if (cosine <= 0.0)
    {
      continue;
    }
    const glm::dvec3 reflected = 2.0 * cosine * n - toward;
    const double specular =
      std::pow(std::max(glm::dot(reflected, view), 0.0), material.Coefficients[3]);
    for (int c = 0; c < 3; ++c)
    {
      color[c] += light.Color[c] *
        static_cast<float>(base[c] * material.Coefficients[1] * cosine +
          material.SpecularColor[c] * material.Coefficients[2] * specular);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    color[c] = std::min(color[c], 1.0f) * base[3];
  }
  color[3] = base[3];
  return color;
}

float BoundaryShading::GetLargestOpacity() const
{
  float largest = 0.0f;
  for (const Material& material : this->Materials)
  {
    largest = std::max(largest, material.Base[3]);
  }
  return largest;
}

bool BoundaryShading::operator==(const BoundaryShading& other) const
{
  const auto isSame = [](const Light& a, const Light& b)
  { return a.Position == b.Position && a.IsPositional == b.IsPositional && a.Color == b.Color; };
  return this->Materials == other.Materials && this->Images == other.Images &&
    this->NormalMatrix == other.NormalMatrix && this->Lights.size() == other.Lights.size() &&
    std::equal(this->Lights.begin(), this->Lights.end(), other.Lights.begin(), isSame);
}

}
