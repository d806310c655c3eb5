// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamSurfaceRepresentation_h
#define vtkStreamSurfaceRepresentation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkSmartPointer.h" // for the textures

class vtkStreamlineTexture;

/**
 * @class   vtkStreamSurfaceRepresentation
 * @brief   surfaces in ParaView with streamlines and timelines whose number follows the zoom
 *
 * Draws like ParaView's Surface, and in addition the lines of vtkStreamlineTexture: streamlines
 * along the first texture coordinate, and timelines along the second one. Lines are drawn over the
 * image that the representation has as its texture, if any.
 *
 * Errors (vtkErrorMacro, once, and the surface is drawn without lines): a block with points has no
 * texture coordinates for the lines, see vtkStreamlineTexture::HasCoordinates.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkStreamSurfaceRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkStreamSurfaceRepresentation* New();
  vtkTypeMacro(vtkStreamSurfaceRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set whether streamlines or timelines are drawn. Default: on and off.
   */
  void SetStreamlines(bool on);
  void SetTimelines(bool on);
  ///@}

  ///@{
  /**
   * Set the texture of the lines. ParaView sets its properties directly. Default: null, no lines.
   */
  void SetStreamlineTexture(vtkStreamlineTexture* texture);
  void SetTimelineTexture(vtkStreamlineTexture* texture);
  ///@}

  void SetTexture(vtkTexture* image) override;
  /// Ignored while lines are drawn.
  void SetInterpolateScalarsBeforeMapping(int on) override;

protected:
  vtkStreamSurfaceRepresentation();
  ~vtkStreamSurfaceRepresentation() override;

  /// Called before each image. Turns lines off if the data have no coordinates for them.
  void UpdateColoringParameters() override;

private:
  vtkStreamSurfaceRepresentation(const vtkStreamSurfaceRepresentation&) = delete;
  void operator=(const vtkStreamSurfaceRepresentation&) = delete;

  /// Sets the textures of the actor.
  void UpdateTextures();

  bool Streamlines = true;
  bool Timelines = false;
  bool HasCoordinates = true;
  int InterpolatesScalars = 0;
  vtkSmartPointer<vtkStreamlineTexture> StreamlineTexture;
  vtkSmartPointer<vtkStreamlineTexture> TimelineTexture;
  vtkSmartPointer<vtkTexture> Image;
};

#endif
