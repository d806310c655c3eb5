// SPDX-License-Identifier: BSD-3-Clause
#include "Software/SoftwareRasterizer.h"

#include "Software/TileRasterizer.h"
#include "View/OpaqueSceneDepth.h"

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
constexpr std::size_t TILES_PER_THREAD = 8;
constexpr double GROUP_SECONDS = 0.1;
}

bool SoftwareRasterizer::Draw(const TetrahedraFrame& frame, const AbortCheck& isAborted)
{
  if ((isAborted && isAborted(0.0)) || !this->UpdateBins(frame, isAborted))
  {
    return false;
  }
  const std::size_t pixels =
    static_cast<std::size_t>(frame.View.GetWidth()) * frame.View.GetHeight();
  const std::vector<int> tiles = this->FindTiles(frame);
  this->Complete = static_cast<int>(tiles.size()) == this->Bins.GetNumberOfTiles();
  if (frame.IsSelection)
  {
    this->Seen.resize(pixels);
    return this->DrawTiles(frame, tiles, isAborted);
  }
  this->HasColors = false;
  this->Colors.resize(4 * pixels);
  if (!this->DrawTiles(frame, tiles, isAborted))
  {
    return false;
  }
  this->HasColors = this->Frame.has_value();
  this->Opaque.assign(frame.Opaque, frame.Opaque ? frame.Opaque + pixels : frame.Opaque);
  return true;
}

bool SoftwareRasterizer::UpdateBins(const TetrahedraFrame& frame, const AbortCheck& isAborted)
{
  if (this->Frame && !frame.IsSum && this->Frame->HasSameImage(frame))
  {
    return true;
  }
  this->Frame.reset();
  this->HasColors = false;
  if (!this->Bins.Fill(frame, [&isAborted]() { return isAborted && isAborted(0.0); }))
  {
    return false;
  }
  // Selections need no order, and sums may be of a part of the tetrahedra.
  if (!frame.IsSum && !frame.IsSelection)
  {
    this->Frame = frame;
  }
  return true;
}

std::vector<int> SoftwareRasterizer::FindTiles(const TetrahedraFrame& frame) const
{
  std::vector<int> tiles;
  for (int tile = 0; tile < this->Bins.GetNumberOfTiles(); ++tile)
  {
    if (frame.IsSelection || !this->HasColors || this->HasChanged(frame, tile))
    {
      tiles.push_back(tile);
    }
  }
  return tiles;
}

bool SoftwareRasterizer::HasChanged(const TetrahedraFrame& frame, int tile) const
{
  const float* before = this->Opaque.empty() ? nullptr : this->Opaque.data();
  const auto depth = [](const float* depths, std::size_t pixel)
  { return depths ? depths[pixel] : OpaqueSceneDepth::NONE; };
  const int width = frame.View.GetWidth();
  const int left = TileBins::SIZE * (tile % this->Bins.GetColumns());
  const int bottom = TileBins::SIZE * (tile / this->Bins.GetColumns());
  const int right = std::min(left + TileBins::SIZE, width);
  const int top = std::min(bottom + TileBins::SIZE, frame.View.GetHeight());
  for (int y = bottom; (before || frame.Opaque) && y < top; ++y)
  {
    for (int x = left; x < right; ++x)
    {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      if (depth(before, pixel) != depth(frame.Opaque, pixel))
      {
        return true;
      }
    }
  }
  return false;
}

bool SoftwareRasterizer::DrawTiles(
  const TetrahedraFrame& frame, const std::vector<int>& tiles, const AbortCheck& isAborted)
{
  const std::size_t threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  std::size_t group = isAborted ? TILES_PER_THREAD * threads : tiles.size();
  for (std::size_t begin = 0, end = 0; begin < tiles.size(); begin = end)
  {
    if (isAborted && isAborted(static_cast<double>(begin) / static_cast<double>(tiles.size())))
    {
      return false;
    }
    const double start = vtkTimerLog::GetUniversalTime();
    end = std::min(begin + group, tiles.size());
    this->DrawGroup(frame, tiles.data() + begin, tiles.data() + end);
    const bool isSlow = vtkTimerLog::GetUniversalTime() - start > GROUP_SECONDS;
    group = isSlow ? std::max(group / 2, threads) : group;
  }
  return true;
}

void SoftwareRasterizer::DrawGroup(const TetrahedraFrame& frame, const int* begin, const int* end)
{
  const auto width = static_cast<std::size_t>(frame.View.GetWidth());
  vtkSMPThreadLocal<std::shared_ptr<TileRasterizer>> rasterizers;
  vtkSMPTools::For(0, end - begin, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      std::shared_ptr<TileRasterizer>& rasterizer = rasterizers.Local();
      if (!rasterizer)
      {
        rasterizer = std::make_shared<TileRasterizer>(frame, this->Bins);
      }
      for (vtkIdType i = first; i < last; ++i)
      {
        rasterizer->Draw(begin[i]);
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
  return this->Bins.GetBytes() +
    (this->Colors.capacity() + this->Opaque.capacity()) * sizeof(float);
}

}
