// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkProjectiveLight_h
#define vtkProjectiveLight_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkLight.h"
#include "vtkSmartPointer.h" // for the image

#include <string> // for error messages
#include <vector> // for texels

class vtkImageData;
class vtkMatrix4x4;

/**
 * @class   vtkProjectiveLight
 * @brief   a light that projects an image, like a slide projector
 *
 * The light screen (C. Zhang, dissertation, Ohio State 2006, 2.3.3) is a rectangle of the given
 * ScreenSize. Its center is the light's focal point, and it is perpendicular to the line from the
 * light's position to the focal point. ViewUp sets its rotation about that line. A positional light
 * shines through the screen in a pyramid, like a slide projector. A directional light shines in a
 * beam with the screen's cross-section.
 *
 * The light at a point is multiplied by the image's color and opacity where the ray to the point
 * passes through the screen. Rays that miss the screen carry no light. Without an image, the screen
 * is a white window.
 *
 * Add the light to a vtkRenderer with AddLight, like any other light. Only volumes of
 * vtkShadowedSliceMapper and actors drawn by vtkShadowedScenePass are lit through the screen. Other
 * mappers treat the light as a vtkLight with the same position, direction and color.
 *
 * Values outside the valid range are clamped. NaN is ignored.
 *
 * @sa vtkAreaLight vtkShadowedSliceMapper vtkShadowedScenePass
 */
class INTERLUMELIGHT_EXPORT vtkProjectiveLight : public vtkLight
{
public:
  static vtkProjectiveLight* New();
  vtkTypeMacro(vtkProjectiveLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the image on the screen. It must be two-dimensional (one sample along z). Its point scalars
   * are integers, from 0 to the largest value of their type (255 for unsigned char, 65535 for
   * unsigned short), or floating point (0 to 1), with 1 (gray), 2 (gray, opacity), 3 (RGB) or 4
   * (RGB, opacity) components. The first row is at the bottom of the screen. With an invalid image,
   * the mapper reports an error and skips the light, and vtkShadowedScenePass does not light actors
   * by it; see GetImageError. Default null: a window that transmits all light.
   */
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const;
  ///@}

  ///@{
  /**
   * Turn on or off interpolation between the image's samples. Default on.
   */
  vtkSetMacro(Interpolate, bool);
  vtkGetMacro(Interpolate, bool);
  vtkBooleanMacro(Interpolate, bool);
  ///@}

  ///@{
  /**
   * Set the width and height of the screen in world units. Default 1, 1. Valid: 1e-30 to 1e30.
   */
  void SetScreenSize(double width, double height);
  vtkGetVector2Macro(ScreenSize, double);
  ///@}

  ///@{
  /**
   * Set the direction that is up on the screen, after projection onto the screen's plane. It is
   * transformed by the light's transform matrix, like the position and the focal point. If it is
   * parallel to the light's axis, another direction is used. Default (0, 1, 0).
   */
  void SetViewUp(double x, double y, double z);
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Set the width of the smooth edge over which the light increases from 0 at the screen's border
   * to its full value, as a fraction of half the screen's width and height. The profile is cubic; 0
   * gives a sharp edge. Default 0. Valid: 0 to 1.
   */
  void SetEdgeWidth(double width);
  vtkGetMacro(EdgeWidth, double);
  ///@}

  ///@{
  /**
   * Set the fraction of light that the screen transmits. It multiplies the image's opacity. Default
   * 1. Valid: 0 to 1.
   */
  void SetScreenOpacity(double opacity);
  vtkGetMacro(ScreenOpacity, double);
  ///@}

  /**
   * Get the transformation from world coordinates to screen coordinates. After division by the
   * fourth coordinate, x and y range from 0 to 1 on the screen. For a positional light, the fourth
   * coordinate is positive only in front of the light; for a directional light, it is always 1.
   * Returns false if the position and the focal point coincide or are not finite.
   */
  bool GetScreenMatrix(vtkMatrix4x4* matrix);

  /**
   * Get the transformation to screen coordinates from a coordinate system in which the light has
   * the given position, focal point and view-up vector, and lengths are \a scale times those in
   * world coordinates.
   */
  bool GetScreenMatrix(const double position[3], const double focalPoint[3], const double viewUp[3],
    double scale, vtkMatrix4x4* matrix) const;

  /**
   * Returns an error message if the image cannot be used, otherwise an empty string.
   */
  std::string GetImageError() const;

  /**
   * Returns the image as RGB texels multiplied by their opacity, with x varying fastest. Values
   * outside 0 to 1 are clamped; NaN becomes 0. The result is empty if there is no valid image.
   */
  std::vector<float> GetTexels() const;

  /**
   * Get the screen's color, multiplied by its opacity and the smooth edge's factor, at screen
   * coordinates (u, v). It is black outside the screen. The factor is s(u) s(v), where s(x) =
   * t^2 (3 - 2 t), and t is the distance from x to the nearer of 0 and 1, divided by EdgeWidth / 2
   * and clamped to 1. The shader computes the same function.
   */
  void GetScreenColor(double u, double v, double color[3]) const;

  /**
   * Returns the latest modification time of the light and its image.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Returns a new projective light with the same values and the same image object.
   * vtkLight::DeepCopy, which is not virtual, copies only the values of vtkLight.
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
