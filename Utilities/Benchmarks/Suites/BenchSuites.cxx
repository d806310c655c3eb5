// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/FlowTexture/FlowTextureError.h"
#include "Benchmarks/Suites/BenchParts.h"

namespace
{
BenchSuite MakeTablesSuite()
{
  return { "tables",
    "number of entries, mean and maximum number of simplices of every interval table",
    { "Each row contains the number of simplices per case, over all cases of the table of one cell "
      "type. Method source-order is a placing triangulation in the order of the source's edge "
      "lists and reproduces Table 3.2 of C. Zhang, dissertation, Ohio State 2006, except for the "
      "mean of the four-dimensional cube: all cases have a mean of 59.36, but 41.25 is printed. "
      "The printed maximum is the same. Method shipped "
      "is the rule of the filters on structured grids: a pulling triangulation with grid points "
      "first, then intersections with the lower bound, then intersections with the upper bound.",
      "For the four-dimensional cube all 3^16 cases are counted by symmetry: one convex hull for "
      "each of the 132,102 cases up to symmetry, and one triangulation for each image of each "
      "facet." },
    { MakeTablesPart() } };
}

BenchSuite MakeIntervalSuite()
{
  return { "interval", "vtkIntervalVolume: run time, memory, orientation, error against run time",
    { "interval-volume: vtkIntervalVolume, with a new filter for each run.",
      "Baseline clip2 is two passes of vtkTableBasedClipDataSet, which produce mixed cells. "
      "Baseline clip2-tetrahedra converts these cells to tetrahedra by vtkDataSetTriangleFilter. "
      "Each dataset has one point array.",
      "threads-2: the same extraction with two threads, relative to one thread.",
      "drag, drag-tied: an interval reaches up to the end of the scalar range, and its lower bound "
      "moves by 1/200 of the range between updates. The bound is in the low, middle or high part "
      "of the range. ReuseMemory is on; the baseline new-memory has it off. In drag no bound "
      "equals a scalar of the data; in drag-tied bounds and scalars are integers.",
      "Count changed is the number of cells that the bound passes through between two updates, "
      "share the fraction of all cells.",
      "memory: measured in a separate process.",
      "peak_kib is the size of the input plus the largest growth of resident memory; peak_share is "
      "this growth divided by the size of the output. first_use_kib is the memory that case tables "
      "and code required before the measurement; it is not included in peak_kib.",
      "inverted: number of tetrahedra with negative volume; the error is their fraction of the "
      "volume.",
      "hexahedra, hexahedra-unstructured, tetrahedra-5, tetrahedra-6, clip2: error against run "
      "time on analytic fields. The methods use the image itself, the image as unstructured "
      "hexahedra, the image split into five or six tetrahedra per cell (the split is not timed), "
      "and two clips. The reference is the exact region of the trilinear interpolant." },
    { interval::MakeSpeedPart(), interval::MakeDragPart(), interval::MakeMemoryPart(),
      interval::MakeOrientationPart(), interval::MakeErrorPart() } };
}

BenchSuite MakeContourSuite()
{
  return { "contour", "vtkIsotableContour: run time",
    { "isotable-hexahedra: vtkIsotableContour on the data as unstructured hexahedra. Baselines "
      "contour3dlinear and contour3dlinear-merge are vtkContour3DLinearGrid with MergePoints off "
      "and on, without normals and without attributes. vtkIsotableContour merges points and passes "
      "the scalars on.",
      "isotable-hexahedra-unmerged: the same with MergePoints off; the baseline is "
      "contour3dlinear.",
      "isotable-image: vtkIsotableContour on image data. Baseline flyingedges is vtkFlyingEdges3D "
      "without normals and gradients.",
      "The isovalue is the lower bound of the interval of the same case in the suite interval." },
    { interval::MakeContourPart() } };
}

BenchSuite MakeTetrahedraSuite()
{
  return { "tetrahedra", "vtkTimeWeightedTetrahedraMapper: run time and error against run time",
    { "One frame of a gyroid on a grid of cubes with five tetrahedra each, rendered offscreen; the "
      "time includes waiting for OpenGL to finish. The camera rotates by half a degree between "
      "frames, so each frame includes sorting. Methods opengl and software are the render paths; "
      "the count device names the OpenGL device. Baseline projectedtetrahedra is "
      "vtkProjectedTetrahedraMapper. All methods render alternately in the same window.",
      "Error against run time: images of the same field on meshes of increasing resolution, in a "
      "floating-point framebuffer. The reference integrates the formula in 4000 steps along each "
      "view ray. The error of every method includes the interpolation error of the mesh." },
    { tetrahedra::MakeSpeedPart(), tetrahedra::MakeErrorPart() } };
}

BenchSuite MakeInterval4dSuite()
{
  return { "interval4d",
    "vtkTimeVaryingIntervalVolume: run time, tables, memory, counts, error against run time",
    { "All time steps are in memory, with one point array, so only the filter is timed. It "
      "produces projected tetrahedra.",
      "Cases vortex and wave are fields of vtkAnalyticFieldSource. Cases cylinder and delta are "
      "fields of vtkTaperedCylinderSource and vtkDeltaWingSource, which replace the data of C. "
      "Zhang, dissertation, Ohio State 2006. A number in the name is the number of time steps. "
      "Case mug is a simulation.",
      "Counts with the prefix stated_ are the counts printed in the dissertation.",
      "warm: the case table is already filled.", "threads-2: two threads relative to one.",
      "throughput: 4-simplices per second; the parameter is the fraction of grid points inside the "
      "region.",
      "cold: the first execution in a new process with one thread; the baseline warm is a later "
      "execution in the same process.",
      "hit_share is the fraction of table lookups that found their case; kind_hit_share also "
      "counts lookups that found an equivalent case under the symmetries of the cell, since only a "
      "new equivalence class requires a convex hull.",
      "later-slabs: the same fractions for all slabs except the first.",
      "memory: measured in a separate process; peak_kib is the size of two time steps plus the "
      "largest growth of resident memory, and peak_share is peak_kib divided by the size of two "
      "time steps and the output.",
      "slice, interpolate, sampled: regions midway between consecutive time steps, as the time "
      "step (the parameter) is halved. slice cuts the 4-simplices; interpolate extracts from the "
      "mean of both time steps; sampled extracts from the field sampled at that time. The "
      "reference is the analytic region.",
      "order: the fitted exponent of the error against the time step, using errors larger than "
      "four times the error of sampled.",
      "slice-again: the time of a second slice of the same 4-simplices." },
    { interval4d::MakeSpeedPart(), interval4d::MakeFreshPart(), interval4d::MakeThroughputPart(),
      interval4d::MakeErrorPart() } };
}

BenchSuite MakeShadowsSuite()
{
  return { "shadows", "vtkShadowedSliceMapper: cost of lights and shadows, error against run time",
    { "One frame, rendered offscreen; the time includes waiting for OpenGL to finish. The count "
      "device names the OpenGL device. The camera rotates by half a degree between frames. Methods "
      "render alternately in one window, and each keeps its own volume and mapper, so a frame "
      "rebuilds nothing else.",
      "The parameter is the number of directional lights, all on the viewer's side, with a total "
      "intensity of 1.",
      "shadows-off: the same lights without shadows.",
      "unlit: Shade and shadows off and one light in the scene; its baseline no-lights has no "
      "light in the scene.",
      "gpu is vtkGPUVolumeRayCastMapper with one sample per voxel and Shade on; gpu-shadows adds "
      "volumetric shadows of full reach (VTK 9.2 or later).",
      "Error against run time: images with one light in a floating-point framebuffer. The "
      "reference is a ray marcher in double precision that casts a shadow ray from each sample.",
      "Cases \"scattering\" have isotropic single scattering, C = c kd I T, without ambient light "
      "and without surface shading. vtkShadowedSliceMapper renders them with Shade off, and "
      "gpu-shadows with VolumetricScatteringBlending 2 and GlobalIlluminationReach 1, so both "
      "render the same model.",
      "Cases \"shaded\" use equation 2.6 of C. Zhang's dissertation, which gpu-shadows does not "
      "support.",
      "spacing: the parameter is the slice spacing relative to the default.",
      "buffer: the parameter is the size of the light buffer.",
      "gpu-shadows: the parameter is the sample distance in voxels, for view rays and shadow rays.",
      "equal-error: the time of the default settings, compared with the time of gpu-shadows at the "
      "same error, interpolated linearly in the log-log plot." },
    { shadows::MakeSpeedPart(), shadows::MakeErrorPart() } };
}

BenchSuite MakeSoftShadowsSuite()
{
  return { "soft-shadows", "vtkAreaLight: error of soft shadows against run time",
    { "One frame of vtkShadowedSliceMapper, rendered offscreen; the time includes waiting for "
      "OpenGL to finish. One round, positional area light, as wide as the diagonal of the volume, "
      "is 1.5 diagonals away from its center. The medium scatters isotropically. The camera "
      "rotates by half a degree between frames; all methods run alternately.",
      "processor_seconds is the processor time of all threads; over_hard and equal times are based "
      "on it.",
      "Error: images in a floating-point framebuffer. The reference is rendered by the same mapper "
      "with a point light for each of 256 light samples (32 in quick runs). It is the mean of "
      "images with sixteen lights each. Slices have half the default spacing, and the light buffer "
      "has 256^2 (128^2) texels.",
      "sample-layers, the default: the parameter is the number of light samples.",
      "accumulated-convolution, the published method: the parameter is the slice spacing relative "
      "to the default.",
      "\", buffer\": the parameter is the size of the light buffer.",
      "hard: the same light with size 0.",
      "equal-time: the default, compared with the smallest error of the convolution in at most the "
      "same time, or with its fastest setting if all settings take longer." },
    { shadows::MakeSoftShadowPart() } };
}

BenchSuite MakeScatteringSuite()
{
  return { "scattering", "Scattered light: error of the scattering modes against run time",
    { "Frames of vtkShadowedSliceMapper, rendered offscreen; the time includes waiting for OpenGL "
      "to finish. The light and the camera move by half a degree between frames, so scattered "
      "light is computed again for each frame.",
      "slab: slabs of a homogeneous medium in parallel light, rendered from several directions on "
      "both sides and integrated over them. The reference is the reflection and transmission "
      "published by H. C. van de Hulst, \"Multiple Light Scattering\", 1980. The parameter is the "
      "number of grid cells across the slab.",
      "cloud: a cumulus cloud of optical depth about 25, Henyey-Greenstein phase function with g = "
      "0.85, albedo 1. The reference is a Monte Carlo path tracer of this project.",
      "cloud, the view turns: only the camera moves, so the scattered light of the first frame is "
      "reused." },
    { scattering::MakeSlabPart(), scattering::MakeCloudPart() } };
}

BenchSuite MakeMixedSuite()
{
  return { "mixed",
    "vtkShadowedScenePass: error and time of surfaces and volumes under the same lights",
    { "Times are the time of one frame, rendered offscreen, including waiting for OpenGL to "
      "finish. The camera rotates by half a degree between frames. All methods run alternately, "
      "each in its own window.",
      "\"light moves\": lights also rotate, by a fifth of a degree, so shadow maps are rendered "
      "again for each frame.",
      "posts: surfaces only, under a spotlight. The baseline is vtkShadowMapPass with shadow maps "
      "of the same resolution, which is the parameter. The reference for both is a ray caster in "
      "double precision.",
      "bonsai, smoke: spheres with a million triangles in total (the parameter) around a volume. "
      "The baseline is the time of the volume only plus twice the time of the actors, each "
      "rendered by VTK without a pass." },
    { mixed::MakeMapPart(), mixed::MakeCostPart() } };
}

BenchSuite MakeFlowSuite()
{
  return { "flow", "vtkImplicitFlowField, vtkFlowVolume: error against run time, stream volumes",
    {
      "uniform, rotation, saddle, spiral, stiff: linear fields, which trilinear interpolation "
      "reproduces exactly, so streamlines are known in closed form.",
      "source-sink, sphere, abc: the reference is the streamlines of the interpolated field, as in "
      "flow-speed. The parameter is MaximumError divided by the maximum speed, or MaximumError "
      "itself in the stiff fields, which are saddles with the given ratio of eigenvalues that "
      "decay in backward time.",
      "within: the fraction of results that are at most 10 MaximumError times their advection time "
      "away from the exact position of the sample after that time.",
      "RK4 and RK45 are the integrators of vtkStreamTracer.",
      "hurricane: advection with the number of samples per axis in the name, for at most 10 units "
      "of time.",
      "new-mapping, new-interval, new-times: a new stream volume after a change of the inflow "
      "mapping, the interval, or the time range; the baseline is that advection. advections: "
      "number of advections that the change caused.",
      "checkpoints, checkpoints-often: the same advection with a checkpoint every minute, or "
      "whenever the last checkpoint took less than a tenth of the time since; the baseline writes "
      "no checkpoint. written: number of checkpoints.",
      "contraction, beside, around: stream volumes of a disk with closed-form solutions, to "
      "measure table 4.1 of C. Zhang's dissertation.",
      "explicit: a triangle patch advected by vtkRungeKutta4, as in Max, Becker and Crawfis "
      "(1993); the parameter is the number of rings.",
      "implicit: vtkImplicitFlowField, vtkInflowMapping and vtkFlowVolume; the parameter is the "
      "number of samples per axis.",
      "implicit-again: the same after a change of the mapping. implicit-refined: with two levels "
      "of refinement.",
      "The error is the volume of tetrahedra with centers outside the exact stream volume plus the "
      "missing volume, divided by the exact volume.",
    },
    { flow::MakeTolerancePart(), flow::MakeVolumePart(), flow::MakeCheckpointPart(),
      flow::MakeExplicitPart() } };
}

BenchSuite MakeFlowSpeedSuite()
{
  return { "flow-speed",
    "vtkImplicitFlowField against vtkStreamTracer: run time, error against run time",
    {
      "image, hexahedra, tetrahedra: one period of ABC flow, integrated backward from random seeds "
      "to a box just inside the field, with one thread. Points of the unstructured grids are "
      "displaced by up to a tenth of a cell.",
      "streamtracer is vtkStreamTracer without vorticity and with its fastest cell search: the "
      "default on images, vtkStaticCellLocator on unstructured grids (vtkModifiedBSPTree and the "
      "default point locator were slower).",
      "RK4: the parameter is the step in cell lengths. RK45: the parameter is MaximumError; steps "
      "are at most two cells. Its steps are the segments of its output.",
      "Both filters use the field as VTK interpolates it. The error is the mean distance of the "
      "endpoints from the exact streamlines of that field, computed by Boost's "
      "runge_kutta_fehlberg78. On images its steps end at cell faces, with an accuracy of 1e-12. "
      "On other grids its steps are at most a tenth of a cell, with VTK's interpolation and an "
      "accuracy of about 1e-8.",
      "time_error is the mean error of the time at the endpoint; vtkStreamTracer computes this "
      "time with first-order accuracy only.",
      "equal-error: the default of vtkImplicitFlowField, compared with the first setting of "
      "streamtracer with an error at most twice as large, or below 3e-8, the rounding error of its "
      "single-precision points. For each next setting the step is halved, or MaximumError is "
      "divided by ten.",
      "steps_per_second_ratio compares steps per second of processor time at these settings. It "
      "excludes setup_seconds, the time of a run with one streamline including all preprocessing "
      "of the field. The ratio of times equals the ratio of samples per second.",
      "equal-error-again: the same filter executed again on the same grid; it reuses the matching "
      "of cell faces (kept_faces).",
      "threads-2: two threads relative to one.",
    },
    { flow::MakeSpeedPart() } };
}

BenchSuite MakeFlowSharingSuite()
{
  return { "flow-sharing",
    "vtkImplicitFlowField, InterpolateStreamlines: interpolation error and run time",
    {
      "shared: about 100,000 samples on an image, with InterpolateStreamlines on; the baseline "
      "integrates all streamlines. Times are processor times of one thread. The parameter is "
      "MaximumError divided by the maximum speed, also in the stiff saddle.",
      "dense: the same number of samples in a box a quarter as wide.",
      "share: the fraction of samples that are interpolated. The counts median, q99, q999 (99.9 "
      "%) and largest describe their errors in units of the tolerance for the advection time of "
      "the streamline. A result with a different status or id counts as an error of 1e30.",
      "within: the fraction of all results with an error of at most 10.",
    },
    { flow::MakeSharingPart() } };
}

BenchSuite MakeFlowTextureSuite()
{
  return { "flow-texture",
    "vtkImplicitFlowVolumeMapper: time of a frame compared with VTK's ray caster",
    { "Times are the time of one frame, rendered offscreen, including waiting for OpenGL to "
      "finish. The camera rotates by half a degree between frames. All methods run alternately, "
      "each in its own window. The parameter is the number of samples along each axis. All "
      "methods use two samples per voxel. The inflow texture is an image of 256 x 256 texels.",
      "\"unfiltered\": TextureFilter is off.",
      "gpu: vtkGPUVolumeRayCastMapper with four independent floating-point components (u, v, "
      "time and whether a surface was reached), which is VTK's default for four components.",
      "gpu-rgba: the same four components used as color and opacity, with one volume sample and "
      "one table lookup. Both use composite blending, linear interpolation, no shading, no "
      "jittering, fixed sample distances, and an opacity unit distance of one voxel. No view ray "
      "becomes opaque before it leaves the volume.",
      "shadows: Shadows on, with one directional light and slices a quarter of a voxel apart; "
      "the baseline \"no shadows\" renders the same image by ray casting. A second row has a "
      "light that moves between frames; its baseline has a light that does not move. "
      "processor_seconds is the processor time of all threads.",
      "flow-texture-voxels: error against time of a frame, with TextureFilter on and off. The "
      "reference is an image in double precision. The count default is 1 for the default "
      "settings at the finest resolution." },
    { MakeFlowTexturePart(),
      approximations::MakeFamilyPart({ approximations::MakeFlowVoxelFamily() }) } };
}

BenchSuite MakeFilterErrorsSuite()
{
  using namespace approximations;
  return { "filter-errors", "Filters with approximate results: error against run time by setting",
    { "Each case is one question, answered by several settings of a filter and, if available, by "
      "a filter of VTK. All methods run alternately. Errors compare the result with a formula in "
      "double precision.",
      "The count default is 1 for the default settings, at the finest resolution if the "
      "resolution of the data varies.",
      "The count peer is 1 for filters of VTK. The other counts are sizes." },
    { MakeFamilyPart({ MakeContourFamily(), MakeMesherFamily(), MakeCriticalPointFamily(),
      MakeVortexAxisFamily(), MakeStreamSurfaceFamily(), MakeLicStepFamily() }) } };
}

BenchSuite MakeGrowthSuite()
{
  return { "growth", "Growth of run time and memory with N: fitted and theoretical exponents",
    { "growth: each size is measured in a separate process. The parameter is N. seconds is the "
      "median time of executions by new filters. kib is the largest growth of resident memory "
      "during an execution, excluding the input.",
      "time exponent, memory exponent: the exponent of N, fitted by least squares to logarithms. "
      "Time is the processor time of all threads, which excludes other programs.",
      "least and most bound the theoretical exponent; the parameter states the reason. Memory "
      "below 64 KiB counts as 64 KiB.",
      "cells, cells of a contour: vtkIntervalVolume and vtkIsotableContour on a wavelet, with "
      "the same bounds at every resolution.",
      "4-simplices: vtkTimeVaryingIntervalVolume on two time steps of the field VORTEX on one "
      "grid, with a growing interval.",
      "time steps: a moving gyroid, all slabs in one output, with time steps in memory.",
      "written slab by slab: vtkTimeSlabWriter, with each time step created on request, so it "
      "counts in the measured memory.",
      "samples: vtkImplicitFlowField on a hurricane on one grid. One thread, except for samples, "
      "which uses all threads." },
    { growth::MakePart() } };
}
}

std::vector<BenchSuite> MakeAllSuites()
{
  return { MakeTablesSuite(), MakeIntervalSuite(), MakeContourSuite(), MakeTetrahedraSuite(),
    MakeInterval4dSuite(), MakeShadowsSuite(), MakeSoftShadowsSuite(), MakeScatteringSuite(),
    MakeMixedSuite(), MakeFlowSuite(), MakeFlowSpeedSuite(), MakeFlowSharingSuite(),
    MakeFlowTextureSuite(), MakeFilterErrorsSuite(), MakeGrowthSuite() };
}
