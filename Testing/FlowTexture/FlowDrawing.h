// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowDrawing_h
#define FlowDrawing_h

#include "Support/Pictures/FlowPictures.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <memory> // for the stages of random states

namespace reference
{

class Check;

/// The mapper's picture of voxels with the scene's camera and unit distance.
RgbaPicture DrawFlow(vtkImplicitFlowVolumeMapper* mapper, vtkImageData* voxels,
  const FlowScene& scene, vtkVolumeProperty* property = nullptr);

/// Uniform flow along x, which takes its paint from the plane x = -0.5.
FlowEnd Uniform(const Place3& x);

/// A camera that sees the whole cube along \a direction.
vtkSmartPointer<vtkCamera> LookAlong(const Place3& direction, bool isParallel = false);

/// A smooth spot of paint in uniform flow.
Color4 Blob(double u, double v);
FlowScene MakeBlobScene();

/// Voxels of two termination surfaces, 0 and 8, with the arrays Speed, and Ways of three
/// components.
vtkSmartPointer<vtkImageData> MakeTwoFlows();

/// Paint whose red goes up and down along u, \a frequency radians in all.
vtkSmartPointer<vtkImageData> MakeStripes(double frequency, double alpha);

/// Unit distance and coefficients of paint without highlights.
void SetCoefficients(
  vtkVolumeProperty* property, double unitDistance, double ambient, double diffuse);

/// Errors of colors divided by opacity, in pixels whose opacity is the expected one, so that they
/// show no edge.
struct LightError
{
  double Mean = 0.0;
  double Largest = 0.0;
  int Pixels = 0;
};
LightError CompareLight(const RgbaPicture& found, const RgbaPicture& expected);

/**
 * @struct  FlowShow
 * @brief   a mapper of MakeTwoFlows(), what can be changed about it, and a stage that draws it
 */
struct FlowShow
{
  using State = std::array<double, 17>;

  FlowShow();
  virtual ~FlowShow() = default;

  vtkInterlumeReport* Draw();

  /// Sets gate, arrays, shading, cuts, filter and projection by the last eight of numbers from 0 to
  /// 1, for any state before.
  virtual void Apply(const State& state);

  VolumeStage Stage;
  vtkSmartPointer<vtkImageData> Voxels;
  vtkSmartPointer<vtkCamera> Camera;
  vtkNew<vtkPiecewiseFunction> Gate;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkImplicitFlowVolumeMapper> Mapper;
};

/// Checks that the picture after many random states is that of a new mapper. \a see is called with
/// the report of each.
void CheckRandomStates(const std::function<std::unique_ptr<FlowShow>()>& make,
  const std::function<void(vtkInterlumeReport*)>& see, Check& check);

}

#endif
