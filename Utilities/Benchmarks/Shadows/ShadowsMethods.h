// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShadowsMethods_h
#define ShadowsMethods_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/BenchRow.h"
#include "Support/Pictures/ShadowScene.h"
#include "Support/Pictures/VolumeStage.h"

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
 * The ways to draw a volume that the suite `shadows` measures.
 */
namespace shadows
{
/// vtkGPUVolumeRayCastMapper without shadows, and with its volumetric shadows.
extern const char* const GpuPeer;
extern const char* const GpuShadowsPeer;

/**
 * A volume on a stage that it shares with others, one of which is seen at a time: nothing is made
 * again when methods take turns, and none compiles what another has compiled.
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

  /// One frame from where the camera has moved on by half a degree, until it is done, with so many
  /// threads of vtkSMPTools. The method must outlive the work.
  BenchWork GetFrame(int threads);
  /// The picture from the camera's first position, in floating point.
  reference::RgbaPicture Capture();

  /// Null for a mapper of VTK.
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

/// vtkShadowedSliceMapper, each picture at full quality; \a set changes what is not default.
MethodPointer MakeSlices(reference::VolumeStage& stage, const reference::ShadowScene& scene,
  const std::function<void(vtkShadowedSliceMapper*)>& set = nullptr);

/**
 * vtkGPUVolumeRayCastMapper, a ray for each pixel, with samples so far apart in voxels. With
 * shadows as CastGpuShadows sets them: they need Shade, which is switched on. Null where this VTK
 * has none.
 */
MethodPointer MakeRays(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance);
MethodPointer MakeShadowRays(
  reference::VolumeStage& stage, const reference::ShadowScene& scene, double sampleDistance);

/// A method at one of its settings, and what was measured.
struct Setting
{
  std::string Name;
  double Parameter = 0.0;
  MethodPointer Drawn;
  BenchSeconds Seconds = {};
  double Error = 0.0;
};

/// Times a frame of each, in turn.
void MeasureFrames(std::vector<Setting>& settings, int threads, int repeats);

/// Adds counts of the mapper's last picture: slices, passes, lights and their buffers, bytes.
void AddReport(vtkInterlumeReport* report, BenchRow& row);
}

#endif
