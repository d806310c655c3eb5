// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkAreaLight_h
#define vtkAreaLight_h

#include "InterlumeLightModule.h" // for the export macro
#include "vtkLight.h"
#include "vtkSmartPointer.h" // for the emitter

#include <memory> // for what is kept of the emitter
#include <string> // for its error message
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
 * The emitter is a disc or a rectangle of Size whose centre is the light's position and which is
 * perpendicular to the line from position to focal point; ViewUp turns it around that line. Each
 * point y of it shines as a vtkLight at y does, with the light's cone and fall-off, and what
 * arrives at x is the mean over the emitter (C. Zhang, dissertation, Ohio State 2006, equation
 * 2.13): I(x) = Intensity Color mean of e(y) T(x,y), T the transmittance between x and y, e the
 * colour of the emitter. The penumbra of an edge at distance Z from the light is L dZ / Z wide on a
 * receiver dZ behind the edge, L the light's size across the edge (2.14).
 *
 * A light that is not positional is infinitely far: it has the angular size that Size has at the
 * distance from position to focal point, so that the penumbra is L dZ / distance wide.
 *
 * A light of size 0, 0 is a vtkLight of the same values and takes no more time than that.
 *
 * Add it to a vtkRenderer by AddLight as any other light. Mappers other than vtkShadowedSliceMapper
 * see a vtkLight of the same position, direction and colour. Widgets read where the emitter is from
 * GetCenter, GetNormal, GetEmitterMatrix and GetSize.
 *
 * Values out of range, and NaN, are errors (vtkErrorMacro) and change nothing.
 *
 * @sa vtkProjectiveLight vtkShadowedSliceMapper
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
   * The shape of the emitter: a disc (of different width and height an ellipse), or a square
   * (a rectangle). Default ROUND.
   */
  void SetShape(int shape);
  vtkGetMacro(Shape, int);
  void SetShapeToRound() { this->SetShape(ROUND); }
  void SetShapeToSquare() { this->SetShape(SQUARE); }
  const char* GetShapeAsString() const;
  ///@}

  ///@{
  /**
   * The width and height of the emitter in world units: the diameters of a disc, the edges of a
   * square. Default 0.25, 0.25, which at the default distance of 1 is seen under 14 degrees. Valid:
   * 0 to 1e30.
   */
  void SetSize(double width, double height);
  void SetSize(const double size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, double);
  ///@}

  ///@{
  /**
   * An image as emitter, stretched over width and height: two-dimensional (one sample along z),
   * unsigned char 0 to 255 or floating point 0 to 1, of 1 (grey), 2 (grey, opacity), 3 (RGB) or 4
   * (RGB, opacity) components in its point scalars, interpolated. Its first row is at the bottom.
   * It says from where on the emitter light comes and of which colour, not how much: the light's
   * diffuse and specular colour are multiplied by GetEmitterColor.
   * Default null: uniform and white. An image without samples or of another kind is an error of
   * the mapper, which then leaves this light out. A black one gives no light.
   */
  void SetEmitter(vtkImageData* image);
  vtkImageData* GetEmitter() const;
  ///@}

  ///@{
  /**
   * The direction whose part perpendicular to the axis of light is up on the emitter. Default
   * (0, 1, 0). Valid: finite. Where it is along the axis another is taken. It turns with the
   * light's transform matrix, as position and focal point do.
   */
  void SetViewUp(double x, double y, double z);
  void SetViewUp(const double up[3]) { this->SetViewUp(up[0], up[1], up[2]); }
  vtkGetVector3Macro(ViewUp, double);
  ///@}

  ///@{
  /**
   * Computes the emitter's centre and its normal, which is the direction of light and of length 1,
   * in world coordinates. Return false where position and focal point are the same or not finite.
   */
  bool GetCenter(double center[3]);
  bool GetNormal(double normal[3]);
  ///@}

  /**
   * Fills \a matrix with the rotation and translation from the emitter's coordinates to the
   * world's, which are as a camera's: the origin is the centre, x right and y up as seen along the
   * light, z against it. Returns false where position and focal point are the same or not finite.
   */
  bool GetEmitterMatrix(vtkMatrix4x4* matrix);

  /**
   * Returns an error message if the emitter's image cannot be read, or an empty string.
   */
  std::string GetEmitterError() const;

  struct Sample
  {
    /// Where it is in world coordinates. Light that is not positional goes from here to the
    /// transformed focal point.
    double Position[3];
    /// Its share of the light in red, green and blue; the shares of all samples are exactly 1.
    double Weight[3];
  };

  /**
   * Computes \a count samples of the emitter, stratified, distinct in width and in height, the
   * bright places of an image with more of them than its dark ones; one sample is the centre.
   * The same values give the same samples. Returns none where position and focal point are the same
   * or not finite, or the emitter's image has an error.
   */
  std::vector<Sample> GetSamples(int count);

  /**
   * Computes the mean colour of the emitter divided by that's largest channel; white without an
   * image, and of one with an error.
   */
  void GetEmitterColor(double color[3]) const;

  /**
   * Returns the time of the last change, of the emitter's image too.
   */
  vtkMTimeType GetMTime() override;

  /**
   * Takes all values of \a light, those of its emitter where it is a vtkAreaLight; the image and
   * the transform matrix are shared. vtkLight::DeepCopy is not virtual: called by a pointer to
   * vtkLight it copies what a vtkLight has.
   */
  void DeepCopy(vtkLight* light);

  /**
   * Returns a new area light with the same values, which shares the image.
   */
  vtkLight* ShallowClone() override;

protected:
  vtkAreaLight();
  ~vtkAreaLight() override;

private:
  friend class interlume::EmitterSamples;

  bool GetFrame(interlume::LightFrame& frame);
  /// Returns the colours of the emitter's image, which are found again where it has changed; null
  /// without an image. The image has no error.
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
