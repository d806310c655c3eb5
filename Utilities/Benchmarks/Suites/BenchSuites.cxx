// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Approximations/FilterFamilies.h"
#include "Benchmarks/FlowTexture/FlowTextureError.h"
#include "Benchmarks/Suites/BenchParts.h"

namespace
{
BenchSuite MakeTablesSuite()
{
  return { "tables", "entries, mean and maximum of simplices of every interval table",
    { "The number of simplices of a case, over all cases of the table of a cell. Method "
      "source-order places the points in the order of the source's edge lists, which reproduces "
      "its Table 3.2; method shipped is what the filters use on structured grids: pulling, grid "
      "points first, then lower, then upper crossings.",
      "For the four-dimensional cube every one of the 3^16 cases counts, by symmetry: one hull for "
      "each of the 132,102 kinds of case, one triangulation for each image of each facet." },
    { MakeTablesPart() } };
}

BenchSuite MakeIntervalSuite()
{
  return { "interval", "vtkIntervalVolume: run time, memory, orientation, error against run time",
    { "interval-volume: tetrahedra of vtkIntervalVolume, made anew each time, against clip2, two "
      "passes of vtkTableBasedClipDataSet, which give mixed cells, and clip2-tetrahedra, which "
      "makes them tetrahedra by vtkDataSetTriangleFilter. Each dataset has one point array.",
      "threads-2: the same extraction by two threads against one.",
      "drag, drag-tied: the lower bound of an interval up to the end of the range goes on by a two "
      "hundredth of the range, low, in the middle and high in it, with KeepMemory, against without "
      "(new-memory). Bounds equal no value of the data, or, drag-tied, are whole numbers, as the "
      "data are. changed is the number of cells that the bound passes through between two updates, "
      "share their share.",
      "memory: in a process of its own; peak_kib is the input and the largest growth of resident "
      "memory; peak_share is the growth divided by the output; first_use_kib, which the tables and "
      "the code took before, is not in it.",
      "inverted: tetrahedra of negative volume; the error is the share of volume that they hold.",
      "hexahedra, hexahedra-unstructured, tetrahedra-5, -6, clip2: error against run time on "
      "analytic fields, for the grid as it is, as unstructured hexahedra, split beforehand into "
      "tetrahedra (seconds without the split), and clipped twice. The reference is the exact "
      "region of the trilinear interpolant of the grid's values." },
    { interval::MakeSpeedPart(), interval::MakeDragPart(), interval::MakeMemoryPart(),
      interval::MakeOrientationPart(), interval::MakeErrorPart() } };
}

BenchSuite MakeContourSuite()
{
  return { "contour", "vtkIsotableContour: run time",
    { "isotable-hexahedra: vtkIsotableContour on the unstructured hexahedra of each case, against "
      "contour3dlinear and contour3dlinear-merge, vtkContour3DLinearGrid with MergePoints off and "
      "on; neither normals nor attributes. vtkIsotableContour merges points and carries the "
      "scalar.",
      "isotable-hexahedra-unmerged: the same with MergePoints off, against contour3dlinear.",
      "isotable-image: vtkIsotableContour on image data, against flyingedges, vtkFlyingEdges3D "
      "without normals and gradients.",
      "The contour value is the lower bound of the case's interval." },
    { interval::MakeContourPart() } };
}

BenchSuite MakeTetrahedraSuite()
{
  return { "tetrahedra", "vtkTimeWeightedTetrahedraMapper: run time and error against run time",
    { "One frame of a gyroid in cubes of five tetrahedra, off-screen, until OpenGL says it is "
      "done. The camera turns by half a degree from frame to frame, so that sorting is part of "
      "each. Methods opengl and software are the render paths, on the device that the counts name; "
      "the peer projectedtetrahedra is vtkProjectedTetrahedraMapper, one of the methods that take "
      "turns in the same window.",
      "Error against run time: pictures of the same field on ever finer meshes, in a float "
      "framebuffer, against the picture of the formula by 4000 steps along each line of sight. "
      "The mesh's own error is in every method's." },
    { tetrahedra::MakeSpeedPart(), tetrahedra::MakeErrorPart() } };
}

BenchSuite MakeInterval4dSuite()
{
  return { "interval4d",
    "vtkTimeVaryingIntervalVolume: run time, tables, memory, counts, error against run time",
    { "The time steps are in memory, with one point array, so that the filter alone is timed; it "
      "makes projected tetrahedra. vortex and wave are fields of vtkAnalyticFieldSource, cylinder "
      "and delta those of vtkTaperedCylinderSource and vtkDeltaWingSource, which stand in for the "
      "data of the source, C. Zhang, dissertation, Ohio State 2006, with the number of time steps; "
      "mug is real. stated_ are the counts of the source. warm: the table holds every case. "
      "threads-2: two threads against one. throughput: 4-simplices a second; the parameter is the "
      "share of points inside.",
      "cold: the first execution in a fresh process, 1 thread, against later ones in the same one "
      "(peer warm). hit_share is the share of lookups that found their case made; kind_hit_share "
      "counts those too that found a case of the same kind, that is equal up to a symmetry of the "
      "cell: only a new kind needs a convex hull. later-slabs: the same for all slabs but the "
      "first. memory: in a process of its own; peak_kib is two time steps and the largest growth "
      "of resident memory; peak_share is that divided by two time steps and the output.",
      "slice, interpolate, sampled: the regions midway between every two time steps as the time "
      "step (the parameter) is halved, as slices of 4-simplices; from the mean of the values of "
      "both steps; from the field itself at that time. The reference is the region of the formula. "
      "order: the exponent of errors above four times that of sampled. slice-again: one more slice "
      "of the same 4-simplices." },
    { interval4d::MakeSpeedPart(), interval4d::MakeFreshPart(), interval4d::MakeThroughputPart(),
      interval4d::MakeErrorPart() } };
}

BenchSuite MakeShadowsSuite()
{
  return { "shadows", "vtkShadowedSliceMapper: cost of lights and shadows, error against run time",
    { "One frame, off-screen, until OpenGL says it is done, on the device that the counts name. "
      "The camera turns by half a degree from frame to frame. Each method has a window of its own, "
      "so that nothing but the frame is made when they take turns. The parameter is the number of "
      "directional lights, all on the viewer's side and together of intensity 1. shadows-off: the "
      "same lights without shadows. unlit: Shade and shadows off, "
      "one light in the scene, against no-lights, no light in the scene. gpu is "
      "vtkGPUVolumeRayCastMapper with a sample each voxel and Shade on; gpu-shadows is the same "
      "with volumetric shadows of full reach (from VTK 9.2 on).",
      "Error against run time: pictures of one light in a float framebuffer against a ray marcher "
      "in double precision that follows a ray to the light from every sample. \"scattering\": "
      "every part of the matter scatters light evenly, C = c kd I T, without ambient light and "
      "surfaces; vtkShadowedSliceMapper draws this with Shade off and gpu-shadows with "
      "VolumetricScatteringBlending 2 and GlobalIlluminationReach 1, so that both mean the same "
      "picture. \"shaded\": equation 2.6, which gpu-shadows does not have. spacing: the parameter "
      "is the distance of slices over the default one; buffer: the size of the light's buffer; "
      "gpu-shadows: the distance of samples in voxels, along view and shadow rays alike. "
      "equal-error: the time of the default, and the time of gpu-shadows where a straight line "
      "between its points in the log-log plot has the same error." },
    { shadows::MakeSpeedPart(), shadows::MakeErrorPart() } };
}

BenchSuite MakeSoftShadowsSuite()
{
  return { "soft-shadows", "vtkAreaLight: error of soft shadows against run time",
    { "One frame of vtkShadowedSliceMapper, off-screen, until OpenGL says it is done, with one "
      "round, positional area light, as wide as a diagonal of the volume and 1.5 of them from its "
      "middle. Every part of the matter scatters light evenly. The camera turns by half a degree "
      "from frame to frame; all methods take turns. processor_seconds are those of all threads; "
      "over_hard and equal times are by them.",
      "Error: pictures in a float framebuffer against the same mapper's with each of 256 samples "
      "of the light as a light of its own (32 in quick runs), the mean of pictures of sixteen, "
      "slices at half the default distance and a light buffer of 256^2 (128^2). sample-layers, the "
      "default: the parameter is the number of samples. "
      "accumulated-convolution, the published method: the parameter is the distance of slices over "
      "the default one. \", buffer\": it is the size of the light's buffer. hard: the "
      "light without its extent. equal-time: the default, against the convolution's smallest error "
      "in at most its time, or its fastest setting where all take longer." },
    { shadows::MakeSoftShadowPart() } };
}

BenchSuite MakeScatteringSuite()
{
  return { "scattering", "Scattered light: error of its modes against run time",
    { "Frames of vtkShadowedSliceMapper, off-screen, until OpenGL says they are done, in which the "
      "light and the camera have moved by half a degree, so that scattered light is found anew.",
      "slab: slabs of matter in parallel light, drawn from five directions on either side and "
      "integrated over them, against the reflection and transmission that H. C. van de Hulst, "
      "\"Multiple Light Scattering\", 1980, prints. The parameter is the number of cells of the "
      "grid through the slab.",
      "cloud: a cumulus of an optical depth of about 25, Henyey and Greenstein's g = 0.85, albedo "
      "1, against the paths of our own Monte Carlo solver.",
      "cloud, the view turns: frames in which the light stays, so that what it has scattered is "
      "kept." },
    { scattering::MakeSlabPart(), scattering::MakeCloudPart() } };
}

BenchSuite MakeMixedSuite()
{
  return { "mixed",
    "vtkShadowedScenePass: error and time of surfaces and volumes under the same lights",
    { "Times are those of one frame, off-screen, until OpenGL says it is done; the camera turns by "
      "half a degree from frame to frame, and all methods take turns, each in a window of its own. "
      "\"light moves\": lights turn as well, by a fifth of a degree, so that depth maps are drawn "
      "for each frame.",
      "posts: surfaces alone under a spotlight, beside vtkShadowMapPass with depth maps of the "
      "same resolution, the parameter; both against a ray caster in double precision.",
      "bonsai, smoke: balls of a million triangles (the parameter) around a volume; the peer is "
      "the time of the volume alone plus twice that of the actors, each drawn by VTK without a "
      "pass." },
    { mixed::MakeMapPart(), mixed::MakeCostPart() } };
}

BenchSuite MakeFlowSuite()
{
  return { "flow", "vtkImplicitFlowField, vtkFlowVolume: error against run time, stream volumes",
    {
      "uniform, rotation, saddle, spiral, stiff: linear fields, which interpolation keeps, so that "
      "streamlines are known by formulas; source-sink, sphere, abc: against streamlines of the "
      "interpolated field as in flow-speed. The parameter is MaximumError over the largest speed; "
      "in stiff fields, saddles of that ratio of eigenvalues that damp backward, MaximumError. "
      "within: the share of the answers that are no further than 10 MaximumError times their time "
      "from where the field carries the sample in that time. RK4 and RK45 are those of "
      "vtkStreamTracer.",
      "hurricane: advection of as many samples, at most 10 units of time; new stream volumes when "
      "the inflow mapping, the interval alone, or the range of times alone changes, against that "
      "advection. advections: how often it was done again. checkpoints, checkpoints-often: the "
      "same advection with a checkpoint each minute, and whenever the last one took less than a "
      "tenth of the time since, against that without; written: how often there was one.",
      "contraction, beside, around: the stream volume of a disc where it is known by formulas, "
      "Zhang's table 4.1 measured. explicit: a patch of triangles carried along by vtkRungeKutta4, "
      "in the manner of Max, Becker and Crawfis (1993), the parameter being its rings. implicit: "
      "vtkImplicitFlowField, "
      "vtkInflowMapping and vtkFlowVolume, the parameter being samples a side; implicit-again: the "
      "same after a change of the mapping; implicit-refined: with two levels of refinement. The "
      "error is the volume of tetrahedra whose middle is outside, and the volume missing, over the "
      "tube's.",
    },
    { flow::MakeTolerancePart(), flow::MakeVolumePart(), flow::MakeCheckpointPart(),
      flow::MakeExplicitPart() } };
}

BenchSuite MakeFlowSpeedSuite()
{
  return { "flow-speed",
    "vtkImplicitFlowField against vtkStreamTracer: run time, error against run time",
    {
      "image, hexahedra, tetrahedra: one period of ABC flow, backward from random seeds to a box "
      "just inside the field, 1 thread; the points of the unstructured grids are moved by up to a "
      "tenth of a cell. streamtracer is vtkStreamTracer without vorticity, with the fastest of its "
      "ways to find cells: the default on images, vtkStaticCellLocator on unstructured grids "
      "(vtkModifiedBSPTree and the default's point locator were slower). RK4: the parameter is the "
      "step in lengths of a cell; RK45: MaximumError, steps up to two cells. Its steps are those "
      "of its output. Both work on the field that VTK interpolates. The error is the mean distance "
      "of the ends from the streamlines of that field, by Boost's runge_kutta_fehlberg78: on "
      "images in steps that end at the faces of cells, good to 1e-12; else in steps of at most a "
      "tenth of a cell through VTK's interpolation, good to some 1e-8. time_error is the mean "
      "error of the time at the end: vtkStreamTracer keeps time to first order only.",
      "equal-error: the default of vtkImplicitFlowField against the first setting of streamtracer, "
      "the step halved or MaximumError divided by ten each time, whose error is at most twice as "
      "large, or below 3e-8, to which its points in single precision are rounded. "
      "steps_per_second_ratio compares steps a second of processor time at those settings, without "
      "what one streamline takes with all that is made of the field first, setup_seconds; the "
      "ratio of times is that of samples a second. equal-error-again: the same filter executed "
      "again on the same grid, of which it has kept which faces meet, kept_faces. threads-2: two "
      "threads against one.",
    },
    { flow::MakeSpeedPart() } };
}

BenchSuite MakeFlowSharingSuite()
{
  return { "flow-sharing",
    "vtkImplicitFlowField, ShareStreamlines: error of what is interpolated, run time",
    {
      "shared: about 100,000 samples on an image, with ShareStreamlines against all streamlines, "
      "processor time of one thread; the parameter is MaximumError over the largest speed, in the "
      "stiff saddle too. dense: as many samples in a box a quarter as wide. share: the part of the "
      "samples that are interpolated. Their errors, in units of the tolerance for the time of "
      "their streamline, have median, q99, q999 (99.9 %) and largest; an answer of another status "
      "or id is off by 1e30. within: the part of all answers whose error is at most 10.",
    },
    { flow::MakeSharingPart() } };
}

BenchSuite MakeFlowTextureSuite()
{
  return { "flow-texture", "vtkImplicitFlowVolumeMapper: time of a frame beside VTK's ray caster",
    { "Times are those of one frame, off-screen, until OpenGL says it is done; the camera turns by "
      "half a degree from frame to frame, and all methods take turns, each in a window of its own. "
      "The parameter is the number of samples along each axis; all have a sample each half voxel. "
      "The paint is an image of 256 x 256; \"unfiltered\": with PaintFilter off.",
      "gpu: vtkGPUVolumeRayCastMapper with four independent components of floats (u, v, time and "
      "whether a surface was reached), as VTK draws four components unless it is told otherwise. "
      "gpu-rgba: the same four taken as a colour and an opacity, which is one look at the volume "
      "and one at a table. Both: composite blending, linear interpolation, no shading, no jitter, "
      "no adjustment of distances, opacity for a unit distance of one voxel. Nothing is opaque "
      "enough to end a line of sight before the volume does.",
      "shadows: Shadows on for one directional light, in slices a quarter of a voxel apart, beside "
      "the same picture by lines of sight without (\"no shadows\"); then a light that moves from "
      "frame to frame beside one that stays. processor_seconds is the time of all threads.",
      "flow-texture-voxels: error against time of a frame, with and without PaintFilter, against a "
      "picture in double precision. default 1 in the counts: the default on the finest voxels." },
    { MakeFlowTexturePart(),
      approximations::MakeFamilyPart({ approximations::MakeFlowVoxelFamily() }) } };
}

BenchSuite MakeFilterErrorsSuite()
{
  using namespace approximations;
  return { "filter-errors", "Filters that approximate: error against run time by their settings",
    { "A case is one question: the same done by every setting and, where there is one, by a filter "
      "of VTK; all methods take turns. Errors are those of the result against a formula in double "
      "precision.",
      "default 1 in the counts: the default settings, and where the size is that of the data, its "
      "finest; peer 1: by VTK. The other counts are sizes." },
    { MakeFamilyPart({ MakeContourFamily(), MakeMesherFamily(), MakeCriticalPointFamily(),
      MakeVortexAxisFamily(), MakeStreamSurfaceFamily(), MakeLicStepFamily() }) } };
}

BenchSuite MakeGrowthSuite()
{
  return { "growth", "Run time and memory against N: fitted exponents beside theory's",
    { "growth: each size in a process of its own. The parameter is N; seconds are of executions by "
      "filters made anew, medians; kib is how much the resident memory grew at most in an "
      "execution, over the input and what was there before.",
      "time exponent, memory exponent: the exponent of N, the slope of a line through the "
      "logarithms by least squares, for the processor time of all threads, which excludes other "
      "programs, and the memory; least and most are theory's, the parameter states the reason. "
      "Memory below 64 KiB counts as 64 KiB.",
      "cells, cells of a contour: vtkIntervalVolume and vtkIsotableContour of a wavelet, the "
      "values the same at every resolution. 4-simplices: vtkTimeVaryingIntervalVolume of two steps "
      "of the field VORTEX on one grid, the interval growing. time steps: of a gyroid that moves, "
      "all slabs in one output, steps in memory; written slab by slab: by vtkTimeSlabWriter, each "
      "step made when it is requested and in the memory that is measured. samples: "
      "vtkImplicitFlowField of a hurricane on one grid. 1 thread, but samples by all." },
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
