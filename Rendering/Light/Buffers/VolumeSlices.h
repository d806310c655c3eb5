// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeSlices_h
#define interlume_VolumeSlices_h

#include "Buffers/SliceOcclusion.h"
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
 * @brief   draws the slices of one volume into an image
 *
 * Volumes rendered together are sliced by the same planes, but each has its own polygons, programs
 * and textures. GPUs have too few texture units for the textures of all volumes, so only one
 * volume's textures are bound at a time.
 */
class VolumeSlices
{
public:
  VolumeSlices();
  ~VolumeSlices();

  /// Sets the volume to draw.
  void Set(const VolumeRenderState& frame, SliceTextures& textures);
  const VolumeRenderState& GetFrame() const { return *this->Frame; }
  SliceTextures& GetTextures() { return *this->Textures; }

  /// Returns the length by which blocks at the volume's boundary are enlarged, in unit space. The
  /// enlarged blocks cover view and light rays that pass through the volume in a slab but miss its
  /// cross section with the slab's middle plane.
  static double GetMargin(const SlicePlan::Sweep& sweep);

  /// Cuts the slices of a sweep and uploads their triangles. Returns the size of the triangles in
  /// bytes.
  vtkIdType Cut(const SlicePlan::Sweep& sweep);
  bool IsEmpty(int slab) const { return this->Polygons.IsEmpty(slab); }
  bool IsEmpty() const { return this->Polygons.GetVertices().empty(); }
  /// Returns true if a slab is out of view. A light may still reach it.
  bool IsOutOfView(int slab) const { return this->GetSeen().IsEmpty(slab); }
  const SlicePolygons& GetPolygons() const { return this->Polygons; }
  vtkOpenGLBufferObject* GetVertices() { return this->Vertices; }

  /**
   * Prepares the programs that draw the camera's view in a sweep. If \a isMarked is true, each slab
   * is drawn at a separate depth. \a activate binds the textures that all volumes share. A volume
   * without triangles has no programs. Returns an error if a program cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, std::size_t sweep, bool isOccluded, bool isMarked,
    const std::function<void(vtkShaderProgram*)>& activate);
  /// Adds a program that reads the volume's textures, which must be bound.
  void Add(vtkShaderProgram* program);
  bool HasThickPart() const { return this->IsThick; }
  vtkShaderProgram* GetThickProgram() const { return this->SecondPass.GetProgram(); }

  /// Draws a slab into the bound image. \a number is the index of this volume, from 0 to \a volumes
  /// - 1.
  void Draw(vtkOpenGLRenderWindow* window, const SlicePlan::Sweep& sweep, int slab, int number,
    int volumes);

  /// Marks the opaque pixels of \a image in a slab.
  void MarkOpaquePixels(
    vtkOpenGLRenderWindow* window, SliceOcclusion& occlusion, vtkTextureObject* image, int slab);

  ///@{
  /// Bind the volume's textures, and unbind them temporarily.
  void Resume(vtkOpenGLRenderWindow* window);
  void Suspend();
  ///@}
  /// Unbinds the textures at the end of the sweep.
  void End();

  void ReleaseGraphicsResources();

private:
  /// Returns the triangles to draw in the camera's view.
  const SlabTriangles& GetSeen() const;

  const VolumeRenderState* Frame = nullptr;
  SliceTextures* Textures = nullptr;
  SlicePolygons Polygons;
  /// Tiles of the camera's view, which replace the polygons.
  PlaneTiles Tiles;
  bool HasTiles = false;
  vtkNew<vtkOpenGLBufferObject> TileVertices;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  /// The first program draws the whole medium, or only its thin part, or only tests for empty
  /// fragments. In the latter two cases, the second program draws the thick part or the whole
  /// medium.
  SlicePass FirstPass;
  SlicePass SecondPass;
  SlicePass MarkPass;
  bool IsThick = false;
  bool IsSplit = false;
  bool IsThin = true;
  bool IsMarked = false;
  std::vector<vtkShaderProgram*> Programs;
};

}

#endif
