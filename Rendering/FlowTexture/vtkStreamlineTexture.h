// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamlineTexture_h
#define vtkStreamlineTexture_h

#include "InterlumeFlowTextureModule.h" // for the export macro
#include "vtkOpenGLTexture.h"

class vtkActor;

/**
 * @class   vtkStreamlineTexture
 * @brief   stripes along texture coordinates, in a mip pyramid that is not averaged
 *
 * Draws lines of constant s (or t) on a textured surface: streamlines of a stream surface whose
 * first texture coordinate tells them apart, timelines of one whose second is the time (C. Zhang,
 * dissertation, Ohio State 2006, section 4.5.2, figures 4.7 and 4.8).
 *
 * Level k of the pyramid holds NumberOfLines / 2^k lines over 0 ... 1, all of the same width in
 * texels; the texture repeats beyond. A common pyramid averages lines to grey where they are narrow
 * on screen; this one has fewer of them there. Levels are blended (trilinear), so that lines fade
 * in as the surface comes closer. Lines are TexelsPerLine / sqrt(2) to sqrt(2) TexelsPerLine pixels
 * apart along the axis of the screen across which they are closest, as long as that needs no more
 * than NumberOfLines (then they grow with the surface) and not less than one over 0 ... 1.
 *
 * The texture multiplies the surface's colour after lighting, as any texture of an actor: a white
 * background keeps it, a background of opacity 0 leaves lines alone. Colours that the mapper looks
 * up in a texture of its own (InterpolateScalarsBeforeMapping) are not multiplied, which is a limit
 * of vtkOpenGLPolyDataMapper. The surface needs active texture coordinates of one or two
 * components.
 *
 * **Grids** of streamlines and timelines are two textures, one for each direction (AddTo). In one
 * texture, both directions would have one level: that of the direction that is narrower on screen,
 * too few lines in the other; or, with anisotropic filtering, samples along the direction that is
 * narrower, averaged to grey. For that reason anisotropic filtering is off, whatever the actor
 * says.
 *
 * There is no input. Levels are uploaded when the texture is drawn the first time, and again only
 * after a setting has changed, in another window, or after ReleaseGraphicsResources. One texture
 * serves one window at a time.
 *
 * @sa vtkFlowVolume vtkFlowLIC
 */
class INTERLUMEFLOWTEXTURE_EXPORT vtkStreamlineTexture : public vtkOpenGLTexture
{
public:
  static vtkStreamlineTexture* New();
  vtkTypeMacro(vtkStreamlineTexture, vtkOpenGLTexture);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Directions
  {
    /// Lines of constant s, the first texture coordinate.
    S = 0,
    /// Lines of constant t.
    T = 1
  };

  ///@{
  /**
   * The texture coordinate that differs from line to line. Default S. Valid: S, T; clamped.
   */
  vtkSetClampMacro(Direction, int, S, T);
  vtkGetMacro(Direction, int);
  ///@}

  ///@{
  /**
   * The number of lines over texture coordinates 0 to 1 in the finest level; one line is at 0.
   * Default 256. Valid: powers of two from 1 to 4096; others are an error (vtkErrorMacro) and
   * change nothing. A pyramid that OpenGL has no room for is an error when it is drawn, and its
   * finest levels are left out.
   */
  void SetNumberOfLines(int number);
  vtkGetMacro(NumberOfLines, int);
  ///@}

  ///@{
  /**
   * The width of a line as a share of the distance of lines. Default 0.25. Valid: 0 to 1; clamped.
   */
  vtkSetClampMacro(LineWidth, double, 0.0, 1.0);
  vtkGetMacro(LineWidth, double);
  ///@}

  ///@{
  /**
   * The number of texels from line to line in every level, which is also the distance of lines on
   * screen, in pixels. Default 16. Valid: 2 to 256; clamped.
   */
  vtkSetClampMacro(TexelsPerLine, int, 2, 256);
  vtkGetMacro(TexelsPerLine, int);
  ///@}

  ///@{
  /**
   * The colour of lines, which are opaque. Default black (0, 0, 0). Valid: 0 to 1; clamped.
   */
  vtkSetVector3Macro(LineColor, double);
  vtkGetVector3Macro(LineColor, double);
  ///@}

  ///@{
  /**
   * The colour and opacity between lines. Default white, opaque (1, 1, 1, 1). Valid: 0 to 1;
   * clamped.
   */
  vtkSetVector4Macro(BackgroundColor, double);
  vtkGetVector4Macro(BackgroundColor, double);
  ///@}

  /**
   * Gives \a actor a grid: \a streamlines is the actor's texture, \a timelines is laid over it (a
   * texture of the actor's property by the name `timelines`). The background of \a timelines is to
   * be of opacity 0; that of \a streamlines counts. Either may be null, for no lines of that kind.
   */
  static void AddTo(
    vtkActor* actor, vtkStreamlineTexture* streamlines, vtkStreamlineTexture* timelines);

  /// Returns how often levels were uploaded since this texture was made.
  vtkGetMacro(NumberOfUploads, int);

  /// Returns the number of levels of the pyramid, down to a single line.
  int GetNumberOfLevels() const;

  /// Uploads the levels where they are needed, and binds the texture.
  void Render(vtkRenderer* renderer) override;
  void Load(vtkRenderer* renderer) override;

  /// Returns whether the background is translucent.
  int IsTranslucent() override;

protected:
  vtkStreamlineTexture();
  ~vtkStreamlineTexture() override = default;

private:
  vtkStreamlineTexture(const vtkStreamlineTexture&) = delete;
  void operator=(const vtkStreamlineTexture&) = delete;

  void Upload();

  int Direction = S;
  int NumberOfLines = 256;
  double LineWidth = 0.25;
  int TexelsPerLine = 16;
  double LineColor[3] = { 0.0, 0.0, 0.0 };
  double BackgroundColor[4] = { 1.0, 1.0, 1.0, 1.0 };
  int NumberOfUploads = 0;
};

#endif
