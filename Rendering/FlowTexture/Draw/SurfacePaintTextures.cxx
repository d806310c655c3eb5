// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SurfacePaintTextures.h"

#include "Grid/FlowGrid.h"

#include <algorithm>

namespace interlume
{

namespace
{
constexpr int ALL = -1;
}

void SurfacePaintTextures::Assign(const Images& images, const FlowGrid& grid)
{
  this->Paints.clear();
  this->WithoutTexture = 0;
  std::vector<float> surfaces(4, 0.0F);
  const auto find = [&](int id) -> vtkImageData*
  {
    const auto own = images.find(id);
    const auto found = own != images.end() ? own : images.find(ALL);
    return found != images.end() ? found->second.Get() : nullptr;
  };
  for (std::size_t i = 0; i < grid.Ids.size(); ++i)
  {
    vtkImageData* image = find(grid.Ids[i]);
    std::size_t number = 0;
    if (image)
    {
      const auto known = std::find_if(this->Paints.begin(), this->Paints.end(),
        [image](const Paint& paint) { return paint.Image == image; });
      number = static_cast<std::size_t>(known - this->Paints.begin()) + 1;
      if (known == this->Paints.end())
      {
        const auto first = std::find_if(images.begin(), images.end(),
          [image](const auto& other) { return other.second == image; });
        Paint paint;
        paint.Name = first->first == ALL ? "all" : std::to_string(first->first);
        paint.Image = image;
        this->Paints.push_back(paint);
      }
    }
    this->WithoutTexture += image ? 0 : 1;
    surfaces.insert(surfaces.end(),
      { static_cast<float>(number), grid.Periods[i][0] ? 1.0F : 0.0F,
        grid.Periods[i][1] ? 1.0F : 0.0F, 0.0F });
  }
  this->IsUniform = true;
  for (std::size_t i = 8; i < surfaces.size(); ++i)
  {
    this->IsUniform = this->IsUniform && surfaces[i] == surfaces[i - 4];
  }
  if (surfaces != this->Surfaces)
  {
    this->Surfaces = surfaces;
    ++this->Version;
  }
}

}
