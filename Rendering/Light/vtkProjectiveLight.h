// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkProjectiveLight_h
#define vtkProjectiveLight_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkLight.h"
#include "vtkSmartPointer.h" // for the image

#include <string> // for its error message
#include <vector> // for its texels

class vtkImageData;
class vtkMatrix4x4;

/**
 * @class   vtkProjectiveLight
 * @brief   a light that shines through a screen with an image
 *
 * The light screen (C. Zhang, dissertation, Ohio State 2006, 2.3.3) is a rectangle of ScreenSize
 * whose centre is the light's focal point and which is perpendicular to the line from position to
 * focal point; ViewUp turns it around that line. A positional light shines through it in a pyramid
 * from its position, as a slide projector or the light of a window does; a parallel one in a beam
 * of the screen's cross-section. Where no ray passes the screen there is no light: I(x) = Intensity
 * Color screen(x) T(x) (equation 2.8), screen(x) the colour of the image where the ray through x
 * passes, times its opacity; without an image it is 1 on the screen and 0 outside. T is the
 * transmittance.
 *
 * Add it to a vtkRenderer by AddLight as any other light. Mappers other than vtkShadowedSliceMapper
 * see a vtkLight of the same position, direction and colour, without a screen; with
 * vtkShadowedScenePass actors have the screen too.
 *
 * Values outside the valid range are clamped; NaN changes nothing.
 *
 * @sa vtkShadowedSliceMapper
 */
class INTERLUMELIGHT_EXPORT vtkProjectiveLight : public vtkLight
{
public:
  static vtkProjectiveLight* New();
  vtkTypeMacro(vtkProjectiveLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The image on the screen: two-dimensional (one sample along z), unsigned char 0 to 255 or
   * floating point 0 to 1, of 1 (grey), 2 (grey, opacity), 3 (RGB) or 4 (RGB, opacity) components
   * in its point scalars. Its first row is at the bottom of the screen. Default null: a window that
   * all light passes. An image without samples or of another kind is an error of the mapper, which
   * then leaves this light out.
   */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const;
  ///@}

  ///@{
  /**
   * Whether colours between the samples of the image are interpolated. Default on.
   */
  vtkSetMacro(Interpolate, bool);
  vtkGetMacro(Interpolate, bool);
  vtkBooleanMacro(Interpolate, bool);
  ///@}

  ///@{
  /**
   * The width and height of the screen in world units. Default 1, 1. Valid: 1e-30 to 1e30.
   */
  void SetScreenSize(double width, double height);
  vtkGetVector2Macro(ScreenSize, double);
  ///@}

  ///@{
  /**
   * The direction whose part perpendicular to the axis of light is up on the screen. Default
   * (0, 1, 0). Where it is along the axis another is taken. It turns with the light's transform
   * matrix, as position and focal point do.
   */
  void SetViewUp(double x, double y, double z);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * The width of the edge over which the light goes from nothing to all, from the screen's border
   * inwards, as a share of the screen's half width and height; the change is cubic. 0 is a sharp
   * edge. Default 0. Valid: 0 to 1.
   */
  void SetEdgeWidth(double width);
  vtkGetMacro(EdgeWidth, double);
  ///@}

  ///@{
  /**
   * The share of the light that the screen lets through where it is transparent, which multiplies
   * the image's opacity. Default 1. Valid: 0 to 1.
   */
  void SetScreenOpacity(double opacity);
  vtkGetMacro(ScreenOpacity, double);
  ///@}

  /**
   * Fills \a matrix with the transformation from world coordinates to the screen's: after division
   * by the fourth coordinate x and y are 0 to 1 on the screen. A positional light has the fourth
   * coordinate above 0 in front of it only; a parallel one always 1. Returns false where position
   * and focal point are the same or not finite.
   */
  bool GetScreenMatrix(vtkMatrix4x4* matrix);

  /**
   * Fills \a matrix likewise, but for coordinates in which the light has this position, focal point
   * and view up, and lengths are \a scale times those of the world.
   */
  bool GetScreenMatrix(const double position[3], const double focalPoint[3], const double viewUp[3],
    double scale, vtkMatrix4x4* matrix) const;

  /**
   * Returns an error message if the image cannot be read, or an empty string.
   */
  std::string GetImageError() const;

  /**
   * Returns the image as a texture: red, green, blue, each times opacity, of one sample after the
   * other, x fastest. Values outside 0 to 1 are clamped, NaN is 0. Empty without an image, and with
   * one that has an error.
   */
  std::vector<float> GetTexels() const;

  /**
   * Computes the screen's colour, times opacity, at (u,v) of the screen, with the smooth edge;
   * black outside. The edge is s(x) s(y), s(x) = 3 t^2 - 2 t^3, t the distance of x to 0 or 1 over
   * EdgeWidth / 2. This is what the shader computes, for tests and error norms.
   */
  void GetScreenColor(double u, double v, double color[3]) const;

  /**
   * Returns the time of the last change, of the image too.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Returns a new projective light with the same values, which shares the image.
   * vtkLight::DeepCopy, which is not virtual, copies what a vtkLight has.
   */
  vtkLight* ShallowClone() override;

protected:
  vtkProjectiveLight();
  ~vtkProjectiveLight() override;

private:
  vtkProjectiveLight(const vtkProjectiveLight&) = delete;
  void operator=(const vtkProjectiveLight&) = delete;

  vtkSmartPointer<vtkImageData> Image;
  bool Interpolate = true;
  double ScreenSize[2] = { 1.0, 1.0 };
  double ViewUp[3] = { 0.0, 1.0, 0.0 };
  double EdgeWidth = 0.0;
  double ScreenOpacity = 1.0;
};

#endif
