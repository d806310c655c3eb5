// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkConstructiveModelSource_h
#define vtkConstructiveModelSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkConstructiveVolume.h"
#include "vtkSmartPointer.h" // for the models

/**
 * @class   vtkConstructiveModelSource
 * @brief   samples one of the named models of constructive volume geometry
 *
 * The root object, the bounds and the dimensions follow from the model and the resolution when
 * either is set, the margin being a twentieth of the longest side.
 *
 * The models follow the figures of C. Zhang, dissertation, Ohio State 2006, chapter 2. Units of
 * length are those of the model, z is up. Models that stand on a floor stand on z = 0.
 * - FUZZY_SPHERE (figure 2.5): the sphere of equation 2.7, outer radius 0.5, inner radius 0.2,
 *   around the origin; a vtkSpatialPrimitive. The others are vtkSpatialOperation.
 * - ROBOT (figure 2.6): the union of two cubes, head and body of sides 0.28 and 0.5, and two boxes,
 *   the legs, 0.16 x 0.2 x 0.45. Its front is -y. Bounds -0.25 to 0.25, -0.25 to 0.25, 0 to 1.23.
 * - RINGS (figure 2.7): the union of seven tori. One of radius 0.65 and tube radius 0.06 lies in
 *   z = 0 around the origin, six of 0.26 and 0.05 are threaded on it, every 60 degrees, and lean to
 *   either side. They are within -0.98 to 0.98, -0.98 to 0.98, -0.31 to 0.31.
 * - TWO_SPHERES (figure 2.11): the union of a sphere of radius 0.5 around the origin and one of
 * 0.28 around (0.4, -0.32, 0.5), which overlap a little.
 * - HYPERTEXTURE_SPHERE (figure 2.12): a sphere of radius 0.5 around the origin, displaced by a
 *   fractal sum of noise. Bounds -0.75 to 0.75.
 * - TEDDY_BEAR (in place of the data of figure 2.13): a blend of ellipsoids with soft edges, whose
 *   density is eroded to fur, and eyes and nose. It sits on z = 0 and looks to -y. It is within
 *   -0.55 to 0.55, -0.62 to 0.4, 0 to 1.32.
 * - ROOM (figures 2.9 and 2.16): a floor, a wall at +y with a window and a wall at -x, 0.05 thick.
 *   Its inside is -1 to 1, -1 to 1, 0 to 1.5, open to the other sides. The window is 0.8 wide and
 *   0.7 high, around (0, 1, 0.85), with a cross of 0.04.
 * - DESK (figure 2.16): a top of 0.9 x 0.5 x 0.05 and four legs of 0.06 x 0.06. Bounds -0.45 to
 *   0.45, -0.25 to 0.25, 0 to 0.55.
 * - CHAIR (figure 2.16): a seat of 0.34 x 0.34 x 0.04 at 0.32, a back at +y and four legs. Bounds
 *   -0.17 to 0.17, -0.17 to 0.17, 0 to 0.72.
 */
class INTERLUMESOURCES_EXPORT vtkConstructiveModelSource : public vtkConstructiveVolume
{
public:
  static vtkConstructiveModelSource* New();
  vtkTypeMacro(vtkConstructiveModelSource, vtkConstructiveVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Models
  {
    FUZZY_SPHERE = 0,
    ROBOT = 1,
    RINGS = 2,
    TWO_SPHERES = 3,
    HYPERTEXTURE_SPHERE = 4,
    TEDDY_BEAR = 5,
    ROOM = 6,
    DESK = 7,
    CHAIR = 8,
    NUMBER_OF_MODELS = 9
  };

  /// Returns the model's name in small letters; null for a number that is not a model.
  static const char* GetModelName(int model);

  /// Makes a new object of a model; returns null for a number that is not a model.
  static vtkSmartPointer<vtkSpatialObject> MakeModel(int model);

  ///@{
  /**
   * The model that is sampled. Default ROBOT. Valid: see Models; clamped.
   */
  void SetModel(int model);
  vtkGetMacro(Model, int);
  ///@}

  ///@{
  /**
   * The number of points of the longest side. Default 128. Valid: 2 to 2048; clamped.
   */
  void SetResolution(int resolution);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkConstructiveModelSource();
  ~vtkConstructiveModelSource() override = default;

private:
  vtkConstructiveModelSource(const vtkConstructiveModelSource&) = delete;
  void operator=(const vtkConstructiveModelSource&) = delete;

  int Model = ROBOT;
  int Resolution = 128;
};

#endif
