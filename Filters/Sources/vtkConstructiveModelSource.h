// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkConstructiveModelSource_h
#define vtkConstructiveModelSource_h

#include "InterlumeSourcesModule.h" // for the export macro
#include "vtkConstructiveVolume.h"
#include "vtkSmartPointer.h" // for the models

/**
 * @class   vtkConstructiveModelSource
 * @brief   sample a predefined model of constructive volume geometry
 *
 * Setting the model or the resolution also sets the root object, the bounds and the dimensions. The
 * margin around the model is a twentieth of its longest side.
 *
 * The models follow figures of C. Zhang's dissertation, Ohio State 2006, chapter 2. The z axis
 * points up.
 * - FUZZY_SPHERE (figure 2.5): a vtkSpatialPrimitive at the origin, outer radius 0.5, inner radius
 *   0.2. All other models are vtkSpatialOperation objects.
 * - ROBOT (figure 2.6): a union of two cubes, the head and the body, and two boxes, the legs. It
 *   faces -y. Bounds -0.25 to 0.25, -0.25 to 0.25, 0 to 1.23.
 * - RINGS (figure 2.7): a union of seven tori. One of radius 0.65 and tube radius 0.06 lies in
 *   z = 0 around the origin. Six of radius 0.26 and tube radius 0.05 are threaded on it, 60 degrees
 *   apart, tilted to alternating sides. Bounds -0.98 to 0.98, -0.98 to 0.98, -0.31 to 0.31.
 * - TWO_SPHERES (figure 2.11): a union of a sphere of radius 0.5 at the origin and a sphere of
 *   radius 0.28 at (0.4, -0.32, 0.5), which overlap slightly.
 * - HYPERTEXTURE_SPHERE (figure 2.12): a sphere of radius 0.5 at the origin, displaced by a fractal
 *   sum of noise. Bounds -0.75 to 0.75.
 * - TEDDY_BEAR (replaces the data of figure 2.13): a blend of ellipsoids, eroded to fur, with eyes
 *   and a nose. It sits on z = 0 and faces -y. Bounds -0.55 to 0.55, -0.62 to 0.4, 0 to 1.32.
 * - ROOM (figures 2.9 and 2.16): a floor, a wall at -x, and a wall at +y with a window, all 0.05
 *   thick. The interior is -1 to 1, -1 to 1, 0 to 1.5, open at the other sides. The window is 0.8
 *   wide and 0.7 high, centered at (0, 1, 0.85), with a cross 0.04 wide.
 * - DESK (figure 2.16): a top of 0.9 x 0.5 x 0.05 and four legs of 0.06 x 0.06. Bounds -0.45 to
 *   0.45, -0.25 to 0.25, 0 to 0.55.
 * - CHAIR (figure 2.16): a seat of 0.34 x 0.34 x 0.04 at height 0.32, a back at +y and four legs.
 *   Bounds -0.17 to 0.17, -0.17 to 0.17, 0 to 0.72.
 *
 * @sa vtkConstructiveVolume vtkSpatialObject
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

  /// Returns the lowercase name of a model, or null if there is no such model.
  static const char* GetModelName(int model);

  /// Returns a new object for a model, or null if there is no such model.
  static vtkSmartPointer<vtkSpatialObject> MakeModel(int model);

  ///@{
  /**
   * Set/Get the model. Default ROBOT. Valid: see Models; clamped.
   */
  void SetModel(int model);
  vtkGetMacro(Model, int);
  ///@}

  ///@{
  /**
   * Set/Get the number of points along the longest side. Default 128. Valid: 2 to 2048; clamped.
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
