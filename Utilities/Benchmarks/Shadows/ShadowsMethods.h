// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsMethods_h
#define ShadowsMethods_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Support/Images/ShadowScene.h"
#include "Support/Images/VolumeStage.h"

#include "vtkShadowedSliceMapper.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkCamera;
class vtkVolumeMapper;

/**
 * Methods of rendering a volume in the suite `shadows`.
 */
namespace shadows
{
/// Baselines: vtkGPUVolumeRayCastMapper without and with volumetric shadows.
extern const char* const GpuBaseline;
extern const char* const GpuShadowsBaseline;

/**
 * A volume in a window that several methods share. Only one method is visible at a time.
 * Alternating methods therefore rebuild nothing and share compiled shaders.
 */
class Method
{
public:
  /// The stage must outlive the method.
  Method(
    reference::VolumeStage& stage, const reference::ShadowScene& scene, vtkVolumeMapper* mapper);
  ~Method();
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  /// Returns work that renders one frame with \a threads threads of vtkSMPTools, and waits until
  /// the frame is complete. The camera rotates by half a degree per frame. The method must outlive
  /// the work.
  BenchWork GetFrame(int threads);
  /// Returns the image at the initial camera position, in floating point.
  reference::RgbaImage Capture();

  /// Returns the mapper, or null if the mapper is VTK's.
  vtkShadowedSliceMapper* GetSlices();

private:
  void Show(vtkCamera* camera);

  reference::VolumeStage& Stage;
  reference::ShadowScene Scene;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  int Frames = 0;
};

using MethodPointer = std::unique_ptr<Method>;

/// Creates vtkShadowedSliceMapper at full quality. \a set may change its settings.
MethodPointer MakeSlices(reference::VolumeStage& stage, const reference::ShadowScene& scene,
  const std::function<void(vtkShadowedSliceMapper*)>& set = nullptr);

/**
 * Create vtkGPUVolumeRayCastMapper with one ray per pixel and the given sample distance in voxels.
 * MakeShadowRays() adds shadows by CastGpuShadows() and turns Shade on, which the shadows require.
 * It returns null if this VTK has no volumetric shadows.
 */
MethodPointer MakeRays(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance);
MethodPointer MakeShadowRays(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance);

/// A method with one setting, and its measured time and error.
struct Setting
{
  std::string Name;
  double Parameter = 0.0;
  MethodPointer Drawn;
  BenchSeconds Seconds = {};
  double Error = 0.0;
};

/// Times frames of all settings alternately.
void MeasureFrames(std::vector<Setting>& settings, int threads, int repeats);

/// Adds counts of the last frame to \a row: slices, passes, lights, light buffers, bytes.
void AddReport(vtkInterlumeReport* report, BenchRow& row);
}

#endif
