// SPDX-License-Identifier: BSD-3-Clause
#include "Software/SoftwareRasterizer.h"

#include "Software/TileRasterizer.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <memory>

namespace interlume
{

namespace
{
/// Number of tiles per thread after which to check whether to abort. It is halved while that many
/// tiles take longer than GROUP_SECONDS.
constexpr vtkIdType TILES_PER_THREAD = 8;
constexpr double GROUP_SECONDS = 0.1;
}

bool SoftwareRasterizer::Draw(
  const TetrahedraFrame& frame, const std::function<bool(double fraction)>& isAborted)
{
  const auto stops = [&isAborted](double fraction) { return isAborted && isAborted(fraction); };
  if (stops(0.0))
  {
    return false;
  }
  this->Bins.Fill(frame);
  const std::size_t pixels =
    static_cast<std::size_t>(frame.View.GetWidth()) * frame.View.GetHeight();
  this->Colors.resize(frame.IsSelection ? 0 : 4 * pixels);
  this->Seen.resize(frame.IsSelection ? pixels : 0);
  const vtkIdType tiles = this->Bins.GetNumberOfTiles();
  const auto threads = static_cast<vtkIdType>(vtkSMPTools::GetEstimatedNumberOfThreads());
  vtkIdType group = isAborted ? TILES_PER_THREAD * threads : tiles;
  for (vtkIdType begin = 0, end = 0; begin < tiles; begin = end)
  {
    if (stops(static_cast<double>(begin) / static_cast<double>(tiles)))
    {
      return false;
    }
    const double start = vtkTimerLog::GetUniversalTime();
    end = std::min(begin + group, tiles);
    this->DrawTiles(frame, begin, end);
    const bool isSlow = vtkTimerLog::GetUniversalTime() - start > GROUP_SECONDS;
    group = isSlow ? std::max(group / 2, threads) : group;
  }
  return true;
}

void SoftwareRasterizer::DrawTiles(const TetrahedraFrame& frame, vtkIdType begin, vtkIdType end)
{
  const auto width = static_cast<std::size_t>(frame.View.GetWidth());
  vtkSMPThreadLocal<std::shared_ptr<TileRasterizer>> rasterizers;
  vtkSMPTools::For(begin, end, 1,
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
            if (frame.IsSelection)
            {
              this->Seen[pixel] = rasterizer->GetSeen(x, y);
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
}

std::size_t SoftwareRasterizer::GetBytes() const
{
  return this->Bins.GetBytes() + this->Colors.capacity() * sizeof(float);
}

}
