// SPDX-License-Identifier: BSD-3-Clause
// Batches of slabs for an area light's layers: the slabs in each batch, and triangles that cover
// each texel near the medium exactly once.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Light/ReferenceUnitSpace.h"

#include "Plan/LayerBatches.h"
#include "Plan/SlicePolygons.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;
using interlume::LayerBatches;
using interlume::SlicePlan;
using interlume::SlicePolygons;

constexpr int Size = 64;

// Returns the number of triangles of a batch that contain a position in clip coordinates.
int CountTriangles(const LayerBatches& batches, std::size_t batch, const glm::dvec2& position)
{
  const std::vector<float>& vertices = batches.GetVertices();
  int count = 0;
  for (std::size_t i = batches.GetStarts()[batch]; i < batches.GetStarts()[batch + 1]; i += 3)
  {
    bool isInside = true;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const std::size_t from = 3 * (i + corner);
      const std::size_t to = 3 * (i + (corner + 1) % 3);
      const glm::dvec2 start(vertices[from], vertices[from + 1]);
      const glm::dvec2 edge = glm::dvec2(vertices[to], vertices[to + 1]) - start;
      const glm::dvec2 offset = position - start;
      isInside = isInside && edge.x * offset.y - edge.y * offset.x > 0.0;
    }
    count += isInside ? 1 : 0;
  }
  return count;
}

// Tests a grid of blocks, some of them empty. The light shines along z.
void CheckColumn(Check& check)
{
  const interlume::UnitSpace space = MakeUnitSpace({ { 33, 33, 33 } }, { { 1.0, 1.0, 1.0 } });
  std::array<std::vector<double>, 3> borders;
  for (std::vector<double>& axis : borders)
  {
    for (int block = 0; block <= 4; ++block)
    {
      axis.push_back(0.25 * block);
    }
  }
  std::vector<unsigned char> visible(64, 0);
  // Blocks end slightly before tiles do, so that the border for interpolation is in the next tile.
  borders[0] = { 0.0, 0.24, 0.49, 0.75, 1.0 };
  borders[1] = borders[0];
  // One block is visible where the light enters the volume, and four blocks where it exits.
  visible[0] = 1;
  for (const int block : { 48, 49, 52, 53 })
  {
    visible[static_cast<std::size_t>(block)] = 1;
  }
  SlicePlan::Sweep sweep;
  sweep.Normal = { 0.0, 0.0, 1.0 };
  const std::array<std::array<double, 2>, 3> box{ { { { 0.0, 1.0 } }, { { 0.0, 1.0 } },
    { { 0.0, 1.0 } } } };
  const glm::dvec3 low(space.UnitFromTexture * glm::dvec4(0.0, 0.0, 0.0, 1.0));
  const glm::dvec3 high(space.UnitFromTexture * glm::dvec4(1.0));
  sweep.First = low.z;
  sweep.Slabs = 64;
  sweep.Spacing = (high.z - low.z) / 64.0;
  SlicePolygons polygons;
  polygons.Build(sweep, { borders, visible }, space, box, 0.0);

  SlicePlan::ShadowedLight light;
  light.BufferSize = Size;
  light.BufferFromUnit = glm::dmat4(1.0);
  light.BufferFromUnit[0][0] = 1.0 / high.x;
  light.BufferFromUnit[1][1] = 1.0 / high.y;
  LayerBatches batches;
  // Shadows diverge by two texels in six slabs.
  light.Center = glm::dvec4(0.0, 0.0, -1.0, 0.0);
  light.Spread = 2.0 / (6.01 * sweep.Spacing);
  batches.Build(sweep, light, { &polygons }, false);
  const std::vector<std::array<int, 2>> expected{ { { 0, 5 } }, { { 6, 11 } }, { { 12, 15 } },
    { { 48, 53 } }, { { 54, 59 } }, { { 60, 63 } } };
  check.Equal(batches.Get().size(), expected.size(), "batches");
  for (std::size_t i = 0; i < std::min(batches.Get().size(), expected.size()); ++i)
  {
    check.SetContext("batch " + std::to_string(i));
    check.Equal(batches.Get()[i].First, expected[i][0], "first slab");
    check.Equal(batches.Get()[i].Last, expected[i][1], "last slab");
    const double edge = i < 3 ? 16.0 : i < 5 ? 32.0 : 64.0;
    int missing = 0;
    int duplicate = 0;
    int drawn = 0;
    for (int row = 0; row < Size; ++row)
    {
      for (int column = 0; column < Size; ++column)
      {
        const int count =
          CountTriangles(batches, i, glm::dvec2(column + 0.49, row + 0.52) * (2.0 / Size) - 1.0);
        // Interpolation reads texels past the medium, so these must be drawn, too.
        missing += count == 0 && column < edge + 3.0 && row < edge + 3.0 ? 1 : 0;
        duplicate += count > 1 ? 1 : 0;
        drawn += count;
      }
    }
    check.Equal(missing, 0, "texels near the medium that are not drawn");
    check.Equal(duplicate, 0, "texels that are drawn twice");
    const int tiles = i < 3 ? 4 : i < 5 ? 9 : 16;
    check.Equal(drawn, tiles * LayerBatches::TileSize * LayerBatches::TileSize, "texels drawn");
  }
  check.SetContext("the full buffer");
  light.Spread = 0.0;
  batches.Build(sweep, light, { &polygons }, true);
  check.Equal(batches.Get().size(), 1, "batches of all slabs");
  check.Equal(batches.GetVertices().size(), 4 * 18, "vertex coordinates of four rows");

  // The divergence of a small light's shadows is divided among at least twenty batches. Near a
  // positional light, batches are short.
  check.SetContext("a small light");
  light.Divergence = 12.0 / (64.0 * sweep.Spacing);
  batches.Build(sweep, light, { &polygons }, true);
  check.Equal(batches.Get().front().Last, 2, "slabs per batch of a directional light");
  check.That(!batches.AreSeparated({ 0, 3 }, { 9, 9 }, 2), "six slabs are within two batches");
  check.That(
    batches.AreSeparated({ 0, 3 }, { 10, 10 }, 2), "seven slabs are not within two batches");
  const double thickness = 64.0 * sweep.Spacing;
  light.Center = glm::dvec4(0.0, 0.0, sweep.First - thickness, 1.0);
  // The total divergence is Divergence / (2 thickness) (C. Zhang, dissertation, equation 2.14).
  light.Divergence = 2.0 * 12.0 * thickness;
  batches.Build(sweep, light, { &polygons }, true);
  const auto getSeparation = [](int slab) { return 24.0 * slab / (64.0 + slab); };
  int longest = 0;
  for (const LayerBatches::Batch& batch : batches.Get())
  {
    longest = std::max(longest, batch.Last + 1 - batch.First);
    check.That(getSeparation(batch.Last + 1) - getSeparation(batch.First) < 0.6 + 1e-9,
      "divergence within a batch");
  }
  check.Equal(batches.Get().front().Last, 0, "slabs near a point light");
  check.That(longest >= 4, "slabs far from a point light");
}
}

int TestLayerBatches(int, char*[])
{
  Check check;
  CheckColumn(check);
  return check.Result();
}
