// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAreaLight_h
#define vtkAreaLight_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkLight.h"
#include "vtkSmartPointer.h" // for the emitter

#include <memory> // for the cached emitter colors
#include <string> // for error messages
#include <vector> // for samples

class vtkImageData;
class vtkMatrix4x4;

namespace interlume
{
class EmitterGrid;
class EmitterSamples;
struct LightFrame;
}

/**
 * @class   vtkAreaLight
 * @brief   a light with an extent, which casts soft shadows
 *
 * The emitter is a disk or a rectangle of the given Size. Its center is the light's position, and
 * it is perpendicular to the line from the position to the focal point. ViewUp sets its rotation
 * about that line. Each point of the emitter emits light like a vtkLight at that point, with the
 * light's cone and attenuation. The light that reaches a point is the mean over the emitter. See
 * Documentation/methods/soft-shadows.md.
 *
 * A light that is not positional is infinitely far away. Its emitter has the angular size of an
 * emitter of that Size at the distance between the position and the focal point.
 *
 * A light of size (0, 0) behaves like a vtkLight with the same values and is rendered as fast.
 *
 * Add the light to a vtkRenderer with AddLight, like any other light. Volumes of
 * vtkShadowedSliceMapper and actors in a vtkShadowedScenePass receive its soft shadows. Other
 * mappers treat it as a vtkLight with the same position, direction and color. Widgets get the
 * emitter's position and orientation from GetCenter, GetNormal, GetEmitterMatrix and GetSize.
 *
 * A value out of range, or NaN, is reported by vtkErrorMacro and ignored.
 *
 * @sa vtkProjectiveLight vtkShadowedSliceMapper vtkShadowedScenePass
 */
class INTERLUMELIGHT_EXPORT vtkAreaLight : public vtkLight
{
public:
  static vtkAreaLight* New();
  vtkTypeMacro(vtkAreaLight, vtkLight);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Shapes
  {
    ROUND = 0,
    SQUARE = 1
  };

  ///@{
  /**
   * Set the shape of the emitter: a disk (an ellipse if width and height differ), or a square (a
   * rectangle if they differ). Default ROUND.
   */
  void SetShape(int shape);
  vtkGetMacro(Shape, int);
  void SetShapeToRound() { this->SetShape(ROUND); }
  void SetShapeToSquare() { this->SetShape(SQUARE); }
  const char* GetShapeAsString() const;
  ///@}

  ///@{
  /**
   * Set the width and height of the emitter in world units: the diameters of a disk, or the edge
   * lengths of a square. The default 0.25, 0.25 spans 14 degrees at the default distance of 1.
   * Valid: 0 to 1e30.
   */
  void SetSize(double width, double height);
  void SetSize(const double size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * Set an image that covers the emitter. It must be two-dimensional (one sample along z). Its
   * point scalars are integers, from 0 to the largest value of their type, or floating point (0 to
   * 1), with 1 (gray), 2 (gray, opacity), 3 (RGB) or 4 (RGB, opacity) components. The image is
   * interpolated; its first row is at the bottom.
   *
   * The image distributes the light over the emitter and colors it, but does not change its amount:
   * the light's diffuse and specular colors are multiplied by GetEmitterColor. A black image gives
   * no light. With an invalid image, the mapper reports an error and skips the light; see
   * GetEmitterError. Default null: uniform and white.
   */
  void SetEmitter(vtkImageData* image);
  vtkImageData* GetEmitter() const;
  ///@}

  ///@{
  /**
   * Set the direction that is up on the emitter, after projection onto the emitter's plane. It is
   * transformed by the light's transform matrix, like the position and the focal point. If it is
   * parallel to the light's axis, another direction is used. Default (0, 1, 0). Valid: finite.
   */
  void SetViewUp(double x, double y, double z);
  void SetViewUp(const double up[3]) { this->SetViewUp(up[0], up[1], up[2]); }
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Get the center of the emitter, and its unit normal, which points toward the focal point, in
   * world coordinates. The getters return false if the position and the focal point coincide or are
   * not finite.
   */
  bool GetCenter(double center[3]);
  bool GetNormal(double normal[3]);
  ///@}

  /**
   * Get the rigid transformation from emitter coordinates to world coordinates. The origin is the
   * emitter's center. As in camera coordinates, x points right and y points up, as seen when
   * looking toward the focal point, and z points away from the focal point. Returns false if the
   * position and the focal point coincide or are not finite.
   */
  bool GetEmitterMatrix(vtkMatrix4x4* matrix);

  /**
   * Returns an error message if the emitter's image cannot be used, otherwise an empty string.
   */
  std::string GetEmitterError() const;

  struct Sample
  {
    /// Position in world coordinates. If the light is not positional, its direction is from here to
    /// the transformed focal point.
    double Position[3];
    /// Fraction of the light's red, green and blue that the sample emits. In each channel, the
    /// weights of all samples add up to exactly 1.
    double Weight[3];
  };

  /**
   * Returns \a count stratified samples of the emitter, no two of which have the same coordinate
   * along its width or height. With an image, bright regions get more samples than dark ones. A
   * single sample is at the center. Sampling is deterministic. Returns no samples if the position
   * and the focal point coincide or are not finite, or if the emitter's image is invalid.
   */
  std::vector<Sample> GetSamples(int count);

  /**
   * Get the mean color of the emitter, scaled so that its largest channel is 1. It is white if
   * there is no valid image.
   */
  void GetEmitterColor(double color[3]) const;

  /**
   * Returns the latest modification time of the light and the emitter's image.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Copy all values of \a light, including the emitter if \a light is a vtkAreaLight. The image and
   * the transform matrix are shared. vtkLight::DeepCopy is not virtual: a call through a pointer to
   * vtkLight copies only the values of vtkLight.
   */
  void DeepCopy(vtkLight* light);

  /**
   * Returns a new area light with the same values. The image is shared.
   */
  vtkLight* ShallowClone() override;

protected:
  vtkAreaLight();
  ~vtkAreaLight() override;

private:
  friend class interlume::EmitterSamples;

  bool GetFrame(interlume::LightFrame& frame);
  /// Returns the colors of the emitter's image, or null if there is no image. Recomputes them if
  /// the image has changed. The image must be valid.
  const interlume::EmitterGrid* GetGrid() const;

  int Shape = ROUND;
  double Size[2] = { 0.25, 0.25 };
  vtkSmartPointer<vtkImageData> Emitter;
  mutable std::unique_ptr<const interlume::EmitterGrid> Grid;
  mutable vtkMTimeType GridTime = 0;
  double ViewUp[3] = { 0.0, 1.0, 0.0 };

  vtkAreaLight(const vtkAreaLight&) = delete;
  void operator=(const vtkAreaLight&) = delete;
};

#endif
