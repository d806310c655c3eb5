// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/LayerBatches.h"

#include "Plan/SlicePolygons.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{

// Width of the border around a slice, in light buffer texels. It is sufficient for interpolation in
// the slice's slab, even from layers, whose texels are twice as large.
constexpr double Border = 4.0;

// Maximum number of slabs in a batch. Slabs of the same batch cast hard shadows on each other.
constexpr int LongestBatch = 64;

// Limits for how far shadows cast by light from the emitter's edge and from its center diverge
// within a batch, in texels of the light buffer. The shadows of a small light diverge little over
// the entire volume. Such a light gets at least MinimumBatches batches, unless the divergence
// within a batch would then be less than DivergenceResolution.
constexpr double DivergenceBound = 2.0;
constexpr double DivergenceResolution = 0.25;
constexpr double MinimumBatches = 20.0;

// Tiles of a light buffer.
class Tiles
{
public:
  explicit Tiles(const SlicePlan::ShadowedLight& light)
    : View(light.BufferFromUnit)
    , Size(light.BufferSize)
    , Number((light.BufferSize + LayerBatches::TileSize - 1) / LayerBatches::TileSize)
    , Marks(static_cast<std::size_t>(Number) * Number, 0)
  {
  }

  void MarkAll() { std::fill(this->Marks.begin(), this->Marks.end(), 1); }

  // Marks the tiles that a slab's triangles may intersect.
  void Mark(const SlicePolygons& polygons, int slab)
  {
    const std::vector<float>& vertices = polygons.GetVertices();
    const std::size_t end = polygons.GetStarts()[static_cast<std::size_t>(slab) + 1];
    for (std::size_t i = polygons.GetStarts()[static_cast<std::size_t>(slab)]; i < end; i += 3)
    {
      glm::dvec2 low(2.0);
      glm::dvec2 high(-2.0);
      for (std::size_t corner = i; corner < i + 3; ++corner)
      {
        const glm::dvec4 clip = this->View *
          glm::dvec4(vertices[3 * corner], vertices[3 * corner + 1], vertices[3 * corner + 2], 1.0);
        const glm::dvec2 position = clip.w > 0.0 ? glm::dvec2(clip) / clip.w : glm::dvec2(2.0);
        low = clip.w > 0.0 ? glm::min(low, position) : glm::dvec2(-2.0);
        high = glm::max(high, position);
      }
      this->MarkRectangle(low, high);
    }
  }

  // Appends the triangles of all marked tiles to vertices and clears the marks.
  void Move(std::vector<float>& vertices)
  {
    for (int row = 0; row < this->Number; ++row)
    {
      const auto begin = this->Marks.begin() + static_cast<std::ptrdiff_t>(row) * this->Number;
      const auto end = begin + this->Number;
      for (auto first = std::find(begin, end, 1); first != end; first = std::find(first, end, 1))
      {
        const auto last = std::find(first, end, 0);
        const double left = this->GetClip(first - begin);
        const double right = this->GetClip(last - begin);
        const double bottom = this->GetClip(row);
        const double top = this->GetClip(row + 1);
        const std::array<glm::dvec2, 6> corners{ { { left, bottom }, { right, bottom },
          { right, top }, { left, bottom }, { right, top }, { left, top } } };
        for (const glm::dvec2& corner : corners)
        {
          vertices.insert(
            vertices.end(), { static_cast<float>(corner.x), static_cast<float>(corner.y), 0.0F });
        }
        first = last;
      }
    }
    std::fill(this->Marks.begin(), this->Marks.end(), 0);
  }

private:
  double GetClip(std::ptrdiff_t tile) const
  {
    const auto texel = static_cast<double>(tile * LayerBatches::TileSize);
    return std::min(2.0 * texel / this->Size, 2.0) - 1.0;
  }

  int GetTile(double clip, double border) const
  {
    const double texel = 0.5 * (clip + 1.0) * this->Size + border;
    const double tile = std::floor(texel / LayerBatches::TileSize);
    return static_cast<int>(std::min(std::max(tile, 0.0), this->Number - 1.0));
  }

  void MarkRectangle(const glm::dvec2& low, const glm::dvec2& high)
  {
    const int left = this->GetTile(low.x, -Border);
    const int right = this->GetTile(high.x, Border);
    const int top = this->GetTile(high.y, Border);
    for (int row = this->GetTile(low.y, -Border); row <= top; ++row)
    {
      const auto start = this->Marks.begin() + static_cast<std::ptrdiff_t>(row) * this->Number;
      std::fill(start + left, start + right + 1, 1);
    }
  }

  const glm::dmat4 View;
  const int Size;
  const int Number;
  std::vector<unsigned char> Marks;
};

}

void LayerBatches::FindLimits(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light)
{
  const double slabDivergence = light.Spread * sweep.Spacing;
  this->Period = slabDivergence * LongestBatch > DivergenceBound
    ? std::max(static_cast<int>(DivergenceBound / slabDivergence), 1)
    : LongestBatch;
  const bool isPositional = light.Center.w > 0.0;
  const double start = sweep.First - glm::dot(glm::dvec3(light.Center), sweep.Normal);
  this->Divergences.clear();
  for (int slab = 0; slab <= sweep.Slabs; ++slab)
  {
    const double distance = slab * sweep.Spacing;
    this->Divergences.push_back(
      light.Divergence * (isPositional ? distance / (start * (start + distance)) : distance));
  }
  this->MaximumDivergence =
    std::max(this->Divergences.back() / MinimumBatches, DivergenceResolution);
}

bool LayerBatches::NeedMoreBatches(int first, int end, int batches) const
{
  const double divergence = this->Divergences[static_cast<std::size_t>(end)] -
    this->Divergences[static_cast<std::size_t>(first)];
  return end - first > batches * this->Period || divergence > batches * this->MaximumDivergence;
}

bool LayerBatches::AreSeparated(const Batch& first, const Batch& second, int batches) const
{
  return this->NeedMoreBatches(first.Last, second.First, batches);
}

void LayerBatches::Build(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
  const std::vector<const SlicePolygons*>& polygons, bool coversBuffer)
{
  this->FindLimits(sweep, light);
  this->Batches.clear();
  this->Vertices.clear();
  this->Starts.assign(1, 0);
  const int slabs = polygons.empty() ? 0 : polygons.front()->GetNumberOfSlabs();
  const auto isEmpty = [&polygons](int slab)
  {
    return std::all_of(polygons.begin(), polygons.end(),
      [slab](const SlicePolygons* part) { return part->IsEmpty(slab); });
  };
  for (int slab = 0; slab < slabs; ++slab)
  {
    if (isEmpty(slab))
    {
      continue;
    }
    if (this->Batches.empty() || this->NeedMoreBatches(this->Batches.back().First, slab + 1, 1))
    {
      this->Batches.push_back({ slab, slab });
    }
    this->Batches.back().Last = slab;
  }
  Tiles tiles(light);
  for (const Batch& batch : this->Batches)
  {
    if (coversBuffer || &batch == &this->Batches.back())
    {
      tiles.MarkAll();
    }
    else
    {
      for (int slab = batch.First; slab <= batch.Last; ++slab)
      {
        for (const SlicePolygons* part : polygons)
        {
          tiles.Mark(*part, slab);
        }
      }
    }
    tiles.Move(this->Vertices);
    this->Starts.push_back(this->Vertices.size() / 3);
  }
}

}
