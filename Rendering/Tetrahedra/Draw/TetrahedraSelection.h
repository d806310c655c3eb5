// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraSelection_h
#define interlume_TetrahedraSelection_h

#include "Frame/TetrahedraFrame.h"
#include "Offscreen/ImageQuad.h"
#include "Software/SeenTetrahedra.h"
#include "View/OpaqueSceneDepth.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataSet;
class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkWindow;

namespace interlume
{

class PlaneClip;
class SoftwareRasterizer;

/**
 * @class   TetrahedraSelection
 * @brief   draws the ids of the tetrahedra seen (see SeenTetrahedra) for vtkHardwareSelector
 *
 * The tetrahedra seen are computed once and drawn as colors in each pass of the selector. To select
 * points, each pixel shows the closest corner of the tetrahedron seen there, within POINT_RADIUS.
 */
class TetrahedraSelection
{
public:
  /// Distance in pixels up to which a point is shown, like that of vtkOpenGLPolyDataMapper.
  static constexpr double POINT_RADIUS = 3.0;

  /**
   * Reads the depth of the scene before any volume was drawn for the renderer's selector, because
   * the colors of other volumes have depths as well.
   */
  static void ReadDepth(vtkRenderer* renderer, OpaqueSceneDepth& depth);

  /// Returns true if the pass that the renderer's selector draws can use the tetrahedra that were
  /// found before. The first pass of a selection cannot.
  bool IsFound(vtkRenderer* renderer, vtkProp* prop) const;

  /// The input, and the ids to return (see vtkTimeWeightedTetrahedraMapper::SetSelectionIds).
  struct Source
  {
    vtkDataSet* Grid;
    vtkDataSet* Ids;
  };

  /**
   * Finds the tetrahedra seen, given a frame that contains the parts that \a clip appended. \a
   * rasterizer may have drawn the same frame before, which saves time.
   */
  void Find(vtkRenderer* renderer, vtkProp* prop, const TetrahedraFrame& frame,
    const PlaneClip& clip, const Source& source, SoftwareRasterizer& rasterizer);

  /// Draws the colors of the current pass of the renderer's selector.
  void Draw(vtkRenderer* renderer);

  void ReleaseGraphicsResources(vtkWindow* window) { this->Quad.ReleaseGraphicsResources(window); }

  /// Returns the color of an id in a pass for its 24 lower bits, or for the 24 bits above them.
  static std::array<float, 3> GetColor(vtkIdType id, bool isHigh);

private:
  /// Content of a pixel.
  struct Pixel
  {
    vtkIdType Cell = 0;
    vtkIdType Block = 1;
    vtkIdType Point = -1;
    /// Value of the depth buffer; negative if there is no tetrahedron or, if points are selected,
    /// no point.
    float Depth = -1.0f;
  };

  /// Returns the id of the closest corner of a tetrahedron within POINT_RADIUS, or -1.
  static vtkIdType FindPoint(
    const TetrahedraFrame& frame, std::uint32_t tetrahedron, vtkIdType points, double x, double y);
  /// Replaces the ids of the input by those in \a ids, and sets the maxima.
  void ReplaceIds(vtkDataSet* ids);
  /// Returns the color of a pixel in the current pass.
  std::array<float, 3> GetColor(const Pixel& pixel, vtkHardwareSelector* selector) const;

  vtkRenderer* Renderer = nullptr;
  vtkProp* Prop = nullptr;
  int Width = 0;
  int Height = 0;
  vtkIdType MaximumCell = 0;
  vtkIdType MaximumPoint = 0;
  std::vector<Pixel> Pixels;
  ImageQuad Quad;
};

}

#endif
