// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeSlices_h
#define interlume_VolumeSlices_h

#include "Buffers/SlicePass.h"
#include "Common/Error.h"
#include "Plan/PlaneTiles.h"
#include "Plan/SlicePlan.h"
#include "Plan/SlicePolygons.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <cstddef>
#include <functional>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace interlume
{

class SliceTextures;
struct VolumeRenderState;

/**
 * @class   VolumeSlices
 * @brief   draws one volume into an image of slices
 *
 * Volumes that share the slices of an image have their own polygons in the same planes, and their
 * own programs and textures. The textures of only one volume are bound at a time, since a graphics
 * card has too few units for all.
 */
class VolumeSlices
{
public:
  VolumeSlices();
  ~VolumeSlices();

  /// Sets the volume of an image.
  void Set(const VolumeRenderState& frame, SliceTextures& textures);
  const VolumeRenderState& GetFrame() const { return *this->Frame; }
  SliceTextures& GetTextures() { return *this->Textures; }

  /// Returns the length by which blocks at the edge of the volume are enlarged, so that rays of eye
  /// and light that enter a slab beside the box's own cut meet them.
  static double GetMargin(const SlicePlan::Sweep& sweep);

  /// Cuts the slices of a sweep, and sends their triangles. Returns the bytes of these.
  vtkIdType Cut(const SlicePlan::Sweep& sweep);
  bool IsEmpty(int slab) const { return this->Polygons.IsEmpty(slab); }
  bool IsEmpty() const { return this->Polygons.GetVertices().empty(); }
  /// Returns whether the eye sees nothing of a slab, though a light may.
  bool IsOutOfView(int slab) const { return this->GetSeen().IsEmpty(slab); }
  const SlicePolygons& GetPolygons() const { return this->Polygons; }
  vtkOpenGLBufferObject* GetVertices() { return this->Vertices; }

  /**
   * Makes the eye's programs ready for a sweep. \a isMarked says that some volume of the picture
   * has two programs; \a activate binds what all volumes share. A volume without triangles has no
   * programs. Returns an error if one cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, std::size_t sweep, bool isOccluded, bool isMarked,
    const std::function<void(vtkShaderProgram*)>& activate);
  /// Adds a program that reads the volume's textures, which are bound.
  void Add(vtkShaderProgram* program);
  bool HasThickPart() const { return this->IsThick; }
  vtkShaderProgram* GetThickProgram() const { return this->SecondEye.GetProgram(); }

  /// Draws a slab into the picture that is bound, as one of so many volumes.
  void Draw(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep, int slab, int number,
    int volumes);

  ///@{
  /// Binds the textures of the volume, and unbinds them until then.
  void Resume(vtkOpenGLRenderWindow* window);
  void Suspend();
  ///@}
  /// Unbinds the textures for good.
  void End();

  void ReleaseGraphicsResources();

private:
  /// Returns what the eye's programs draw.
  const SlabTriangles& GetSeen() const;

  const VolumeRenderState* Frame = nullptr;
  SliceTextures* Textures = nullptr;
  SlicePolygons Polygons;
  /// What the eye sees of them, instead of them.
  PlaneTiles Tiles;
  bool HasTiles = false;
  vtkNew<vtkOpenGLBufferObject> TileVertices;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  /// All matter, or all that is thin, or none, where the thick or all matter has a second program.
  SlicePass Eye;
  SlicePass SecondEye;
  bool IsThick = false;
  bool IsSplit = false;
  bool IsThin = true;
  bool IsMarked = false;
  std::vector<vtkShaderProgram*> Programs;
};

}

#endif
