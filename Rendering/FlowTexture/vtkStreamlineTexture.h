// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkStreamlineTexture_h
#define vtkStreamlineTexture_h

#include "InterlumeFlowTextureModule.h" // for the export macro
#include "vtkOpenGLTexture.h"

#include <utility> // for errors

class vtkActor;
class vtkDataSet;

/**
 * @class   vtkStreamlineTexture
 * @brief   stripes along a texture coordinate, with mipmap levels that keep lines sharp
 *
 * Draws lines of constant s or t on a textured surface. On a stream surface these are streamlines
 * (s) or timelines (t) (C. Zhang, dissertation, Ohio State 2006, section 4.5.2).
 *
 * Ordinary mipmaps average thin lines to gray. Here, level k has NumberOfLines / 2^k lines over
 * texture coordinates 0 to 1, with the same width in texels on every level. Farther away there are
 * fewer lines instead of gray. Levels are blended, so lines fade in as the surface gets closer. On
 * screen, lines are TexelsPerLine / sqrt(2) to sqrt(2) * TexelsPerLine pixels apart, in the screen
 * direction in which they are closest. On closer surfaces, where this would require more than
 * NumberOfLines lines, the distance and width of lines on screen grow as the surface gets closer.
 *
 * Like other textures of an actor, the texture multiplies the surface's color after lighting. A
 * white background keeps this color; with a background of opacity 0 only the lines are visible.
 * Turn off InterpolateScalarsBeforeMapping of the mapper: vtkOpenGLPolyDataMapper would use the
 * coordinates of its colors for the lines. The surface needs active texture coordinates with one or
 * two components.
 *
 * A **grid** of streamlines and timelines requires two textures, see AddTo and
 * vtkStreamSurfaceMapper. In a single texture both directions would share one mipmap level.
 * Anisotropic filtering is always off, because it would average lines to gray.
 *
 * Over another texture, lines with a translucent background are composited, and others multiply its
 * colors. When the texture is drawn, it sets its blending mode accordingly.
 *
 * Levels are uploaded when the texture is first drawn, and again after ReleaseGraphicsResources, or
 * if a setting or the window has changed. Use a texture in one window at a time.
 *
 * @sa vtkStreamSurfaceMapper vtkStreamSurfaceParameters vtkFlowLIC
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
   * Set/Get the texture coordinate that is constant on each line. Default S. Valid: S, T; clamped.
   */
  vtkSetClampMacro(Direction, int, S, T);
  vtkGetMacro(Direction, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of lines over texture coordinates 0 to 1 in the finest level. One line is at
   * Offset. Default 256. Valid: powers of two from 1 to 4096; other values are an error and are
   * ignored. If the texture exceeds OpenGL's size limit, drawing it reports an error and omits the
   * finest levels.
   */
  void SetNumberOfLines(int number);
  vtkGetMacro(NumberOfLines, int);
  ///@}

  ///@{
  /**
   * Set/Get the width of a line as a fraction of the distance between lines. Default 0.25. Valid: 0
   * to 1; clamped.
   */
  vtkSetClampMacro(LineWidth, double, 0.0, 1.0);
  vtkGetMacro(LineWidth, double);
  ///@}

  ///@{
  /**
   * Set/Get the texture coordinate of one line; the others follow from it. Change it to move lines,
   * for instance timelines with the flow. Default 0. Valid: any finite value; others are an error
   * and are ignored.
   */
  void SetOffset(double offset);
  vtkGetMacro(Offset, double);
  ///@}

  ///@{
  /**
   * Set/Get the distance between lines in texels, the same on every mipmap level. It is also the
   * approximate distance between lines on screen, in pixels. Default 16. Valid: 2 to 256; clamped.
   */
  vtkSetClampMacro(TexelsPerLine, int, 2, 256);
  vtkGetMacro(TexelsPerLine, int);
  ///@}

  ///@{
  /**
   * Set/Get the color of the lines. Lines are opaque. Default black (0, 0, 0). Valid: 0 to 1;
   * clamped.
   */
  vtkSetVector3Macro(LineColor, double);
  vtkGetVector3Macro(LineColor, double);
  ///@}

  ///@{
  /**
   * Set/Get the color and opacity between lines. Default opaque white (1, 1, 1, 1). Valid: 0 to 1;
   * clamped.
   */
  vtkSetVector4Macro(BackgroundColor, double);
  vtkGetVector4Macro(BackgroundColor, double);
  ///@}

  /**
   * Sets the textures of \a actor: \a below, with \a streamlines and \a timelines over it. Each
   * texture may be null. The lowest of them becomes the actor's texture, and the others become
   * textures `streamlines` and `timelines` of its property.
   */
  static void AddTo(vtkActor* actor, vtkStreamlineTexture* streamlines,
    vtkStreamlineTexture* timelines, vtkTexture* below = nullptr);

  /// Returns whether a dataset has texture coordinates for lines: two components, or one if there
  /// are no timelines.
  static bool HasCoordinates(vtkDataSet* surface, bool hasTimelines);

  /// Copies the settings of the lines of another texture.
  void CopySettings(vtkStreamlineTexture* other);

  /// Returns the number of uploads of this texture.
  vtkGetMacro(NumberOfUploads, int);

  /// Returns the number of mipmap levels, down to a single line.
  int GetNumberOfLevels() const;

  /// Uploads the levels if necessary, and binds the texture.
  void Render(vtkRenderer* renderer) override;
  void Load(vtkRenderer* renderer) override;

  /// Returns 1 if the background is translucent, otherwise 0.
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
  double Offset = 0.0;
  int TexelsPerLine = 16;
  double LineColor[3] = { 0.0, 0.0, 0.0 };
  double BackgroundColor[4] = { 1.0, 1.0, 1.0, 1.0 };
  int NumberOfUploads = 0;
  /// Number and distance of lines with an error, which is reported once.
  std::pair<int, int> TooLarge;
};

#endif
