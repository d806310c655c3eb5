// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamSurfaceMapper_h
#define vtkStreamSurfaceMapper_h

#include "InterlumeFlowTextureModule.h" // for the export macro
#include "vtkNew.h"                     // for the textures
#include "vtkOpenGLPolyDataMapper.h"

#include <string>  // for textures
#include <utility> // for textures
#include <vector>  // for textures

class vtkStreamlineTexture;

/**
 * @class   vtkStreamSurfaceMapper
 * @brief   draw a surface with streamlines and timelines as stripes whose number follows the zoom
 *
 * Draws like vtkPolyDataMapper, and in addition lines of constant texture coordinate: streamlines
 * (lines of constant s) and timelines (constant t). The closer the surface, the more lines are
 * visible, at about the same distance on screen; see vtkStreamlineTexture. Lines are combined with
 * the colors of the mapper, such as those of vtkFlowLIC, and with the actor's textures.
 *
 * Input: vtkPolyData with active texture coordinates of one or two components, as created by
 * vtkStreamSurfaceParameters, or by vtkFlowVolume with ParametersAsTextureCoordinates.
 *
 * The mapper owns its two textures, whose settings are the settings of the lines. For another
 * mapper, such as one of composite data, use vtkStreamlineTexture::AddTo.
 *
 * If both kinds of lines are off, no texture is uploaded, and shaders are those of
 * vtkPolyDataMapper. If lines are on, InterpolateScalarsBeforeMapping has no effect, since VTK
 * would use the coordinates of its colors for the lines.
 *
 * Errors (vtkErrorMacro, the surface is drawn without lines): texture coordinates that are missing
 * or have three components, and timelines if the texture coordinates have one component.
 *
 * @sa vtkStreamlineTexture vtkStreamSurfaceParameters vtkFlowLIC
 */
class INTERLUMEFLOWTEXTURE_EXPORT vtkStreamSurfaceMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkStreamSurfaceMapper* New();
  vtkTypeMacro(vtkStreamSurfaceMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/get whether streamlines, lines of constant s, are drawn. Default on.
   */
  vtkSetMacro(Streamlines, bool);
  vtkGetMacro(Streamlines, bool);
  vtkBooleanMacro(Streamlines, bool);
  ///@}

  ///@{
  /**
   * Set/get whether timelines, lines of constant t, are drawn. Default off.
   */
  vtkSetMacro(Timelines, bool);
  vtkGetMacro(Timelines, bool);
  vtkBooleanMacro(Timelines, bool);
  ///@}

  ///@{
  /**
   * Get the texture of the streamlines or of the timelines, with number, width, distance and colors
   * of the lines. To move timelines with the flow, increase the Offset of their texture.
   */
  vtkStreamlineTexture* GetStreamlineTexture();
  vtkStreamlineTexture* GetTimelineTexture();
  ///@}

  void ShallowCopy(vtkAbstractMapper* mapper) override;
  int CanUseTextureMapForColoring(vtkDataObject* input) override;
  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /// A surface is translucent if the background of its lines is. With both kinds of lines, the
  /// background of the streamlines decides.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;
  ///@}

protected:
  vtkStreamSurfaceMapper();
  ~vtkStreamSurfaceMapper() override;

  unsigned int GetNumberOfTextures(vtkActor* actor) override;
  std::vector<std::pair<vtkTexture*, std::string>> GetTextures(vtkActor* actor) override;

private:
  vtkStreamSurfaceMapper(const vtkStreamSurfaceMapper&) = delete;
  void operator=(const vtkStreamSurfaceMapper&) = delete;

  /// Returns the textures of the lines that are on.
  std::vector<std::pair<vtkTexture*, std::string>> GetLineTextures();
  /// Returns whether the input has texture coordinates for lines, and reports an error if not.
  bool CheckCoordinates();

  bool Streamlines = true;
  bool Timelines = false;
  /// True if the current input has texture coordinates for lines.
  bool HasCoordinates = false;
  /// Modification time of the last input with an error, which is reported once.
  vtkMTimeType FaultyTime = 0;
  vtkNew<vtkStreamlineTexture> StreamlineTexture;
  vtkNew<vtkStreamlineTexture> TimelineTexture;
};

#endif
