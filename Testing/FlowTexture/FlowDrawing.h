// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowDrawing_h
#define FlowDrawing_h

#include "Support/Images/FlowImages.h"
#include "Support/Images/VolumeStage.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <memory> // for the stages of random states

namespace reference
{

class Check;

/// Draws voxels with the camera and the unit distance of a scene.
RgbaImage DrawFlow(vtkImplicitFlowVolumeMapper* mapper, vtkImageData* voxels,
  const FlowScene& scene, vtkVolumeProperty* property = nullptr);

/// Uniform flow along x that starts at the plane x = -0.5.
FlowEnd Uniform(const Position3& x);

/// Returns a camera that looks along \a direction and shows the entire unit cube around the origin.
vtkSmartPointer<vtkCamera> LookAlong(const Position3& direction, bool isParallel = false);

/// Returns the color of an inflow texture with a smooth spot.
Color4 Blob(double u, double v);
FlowScene MakeBlobScene();

/// Returns voxels with two termination surfaces (ids 0 and 8) and the arrays Speed and Ways (three
/// components).
vtkSmartPointer<vtkImageData> MakeTwoFlows();

/// Returns a texture whose red channel is a sine of u with angular frequency \a frequency.
vtkSmartPointer<vtkImageData> MakeStripes(double frequency, double alpha);

/// Sets the unit distance and the lighting coefficients, without specular light.
void SetCoefficients(
  vtkVolumeProperty* property, double unitDistance, double ambient, double diffuse);

/// Errors of unpremultiplied colors. Only pixels with the expected opacity are compared, which
/// excludes edges.
struct LightError
{
  double Mean = 0.0;
  double Largest = 0.0;
  int Pixels = 0;
};
LightError CompareLight(const RgbaImage& found, const RgbaImage& expected);

/**
 * @struct  FlowFixture
 * @brief   draws the voxels of MakeTwoFlows() with a mapper whose settings can be changed
 */
struct FlowFixture
{
  using State = std::array<double, 17>;

  FlowFixture();
  virtual ~FlowFixture() = default;

  vtkInterlumeReport* Draw();

  /// Sets the time gate, arrays, shading, clipping, texture filter and projection from the last
  /// eight numbers of \a state, which are in [0, 1]. The result does not depend on earlier
  /// settings.
  virtual void Apply(const State& state);

  VolumeStage Stage;
  vtkSmartPointer<vtkImageData> Voxels;
  vtkSmartPointer<vtkCamera> Camera;
  vtkNew<vtkPiecewiseFunction> Gate;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkImplicitFlowVolumeMapper> Mapper;
};

/// Draws a coarse image with progressive rendering, and then all passes. Returns the final image.
RgbaImage DrawRefined(FlowFixture& fixture, Check& check);

/// Checks after each of many random states that the image equals that of a new mapper, also with
/// progressive rendering. \a inspect is called with the report of each state.
void CheckRandomStates(const std::function<std::unique_ptr<FlowFixture>()>& make,
  const std::function<void(vtkInterlumeReport*)>& inspect, Check& check);

}

#endif
