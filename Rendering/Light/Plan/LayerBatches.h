// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LayerBatches_h
#define interlume_LayerBatches_h

#include "Plan/SlicePlan.h"

#include <cstddef>
#include <vector>

namespace interlume
{

class SlicePolygons;

/**
 * @class   LayerBatches
 * @brief   the slabs whose matter goes into an area light's layers together, and where it is
 *
 * A batch begins at a slab with matter and has those of a number of slabs from there on. Its tiles
 * are the squares of about TileSize texels of the light's buffer that a slice of the batch, with a
 * border for interpolation, lies in; neighbours in a row are one rectangle. Nothing but them meets
 * matter or has matter that asks for light. The last batch has the whole buffer, so that it is
 * known everywhere in the end.
 */
class LayerBatches
{
public:
  static constexpr int TileSize = 16;

  struct Batch
  {
    /// The first and last slab with something in it.
    int First = 0;
    int Last = 0;
  };

  /// Finds the batches of so many slabs at most, over the matter of all \a polygons. All of them
  /// have the whole buffer where \a isWhole.
  void Build(const SlicePlan::ShadowedLight& light,
    const std::vector<const SlicePolygons*>& polygons, int period, bool isWhole);

  const std::vector<Batch>& Get() const { return this->Batches; }
  /// Returns the corners x, y, 0 of triangles in clip coordinates of the buffer, batch after batch.
  const std::vector<float>& GetVertices() const { return this->Vertices; }
  /// Returns the first vertex of each batch, and their number.
  const std::vector<std::size_t>& GetStarts() const { return this->Starts; }

private:
  std::vector<Batch> Batches;
  std::vector<float> Vertices;
  std::vector<std::size_t> Starts = { 0 };
};

}

#endif
