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
 * @brief   batches of slabs that are multiplied into an area light's layers together
 *
 * A batch starts at a slab that is not empty. Shadows cast by light from the emitter's edge diverge
 * from shadows cast by light from its center. Within a batch, they may diverge by at most two
 * texels of the light buffer, and by at most 1/20 of the divergence over the entire volume. A batch
 * is treated as if all of its extinction were in its central plane, which shifts shadows by up to
 * half the divergence within the batch. The second limit is for small lights, whose penumbras are
 * not much wider than two texels. It adds at most 20 batches.
 *
 * Only tiles of TileSize x TileSize texels that may contain a slice of the batch are drawn, with a
 * border for interpolation. Adjacent tiles of a row are merged into one rectangle. The last
 * batch covers the entire buffer, so that the final transmittance is valid everywhere.
 */
class LayerBatches
{
public:
  static constexpr int TileSize = 16;

  struct Batch
  {
    /// The first and last nonempty slab.
    int First = 0;
    int Last = 0;
  };

  /// Divides the slabs of all \a polygons into batches. If \a coversBuffer is true, each batch
  /// covers the entire buffer.
  void Build(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
    const std::vector<const SlicePolygons*>& polygons, bool coversBuffer);

  /// Returns true if the slabs from the last slab of \a first to the first slab of \a second would
  /// need more than \a batches batches.
  bool AreSeparated(const Batch& first, const Batch& second, int batches) const;

  const std::vector<Batch>& Get() const { return this->Batches; }
  /// Returns the triangle vertices (x, y, 0) of all batches, in clip coordinates of the buffer.
  const std::vector<float>& GetVertices() const { return this->Vertices; }
  /// Returns the index of the first vertex of each batch, followed by the total number of vertices.
  const std::vector<std::size_t>& GetStarts() const { return this->Starts; }

private:
  /// Computes Period, Divergences and MaximumDivergence.
  void FindLimits(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light);
  /// Returns true if the slabs in [first, end) need more than \a batches batches.
  bool NeedMoreBatches(int first, int end, int batches) const;

  std::vector<Batch> Batches;
  /// Maximum number of slabs in a batch.
  int Period = 1;
  /// Divergence of the shadows, in texels, from the sweep's start to the start of each slab and to
  /// the sweep's end. MaximumDivergence is the limit within a batch.
  std::vector<double> Divergences;
  double MaximumDivergence = 0.0;
  std::vector<float> Vertices;
  std::vector<std::size_t> Starts = { 0 };
};

}

#endif
