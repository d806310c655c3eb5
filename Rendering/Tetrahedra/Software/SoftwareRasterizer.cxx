// SPDX-License-Identifier: BSD-3-Clause
#include "Software/SoftwareRasterizer.h"

#include "Software/TileRasterizer.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <memory>

namespace interlume
{

bool SoftwareRasterizer::Draw(const TetrahedraFrame& frame, const std::function<bool()>& isAborted)
{
  this->Bins.Fill(frame);
  if (isAborted())
  {
    return false;
  }
  const auto width = static_cast<std::size_t>(frame.View.GetWidth());
  const std::size_t pixels = width * frame.View.GetHeight();
  const bool isSelection = frame.Blend == TetrahedraFrame::SELECTION;
  this->Colors.resize(isSelection ? 0 : 4 * pixels);
  this->Tetrahedra.resize(isSelection ? pixels : 0);
  this->Depths.resize(isSelection ? pixels : 0);
  vtkSMPThreadLocal<std::shared_ptr<TileRasterizer>> rasterizers;
  vtkSMPTools::For(0, this->Bins.GetNumberOfTiles(), 1,
    [&](vtkIdType first, vtkIdType last)
    {
      std::shared_ptr<TileRasterizer>& rasterizer = rasterizers.Local();
      if (!rasterizer)
      {
        rasterizer = std::make_shared<TileRasterizer>(frame, this->Bins);
      }
      for (vtkIdType tile = first; tile < last; ++tile)
      {
        rasterizer->Draw(static_cast<int>(tile));
        for (int y = 0; y < rasterizer->GetHeight(); ++y)
        {
          for (int x = 0; x < rasterizer->GetWidth(); ++x)
          {
            const std::size_t pixel =
              (rasterizer->GetBottom() + y) * width + rasterizer->GetLeft() + x;
            if (isSelection)
            {
              this->Tetrahedra[pixel] = rasterizer->GetTetrahedron(x, y);
              this->Depths[pixel] = rasterizer->GetDepth(x, y);
            }
            else
            {
              const TileRasterizer::Pixel& color = rasterizer->GetPixel(x, y);
              std::copy(color.begin(), color.end(), &this->Colors[4 * pixel]);
            }
          }
        }
      }
    });
  return true;
}

std::size_t SoftwareRasterizer::GetBytes() const
{
  return this->Bins.GetBytes() + this->Colors.capacity() * sizeof(float);
}

}
