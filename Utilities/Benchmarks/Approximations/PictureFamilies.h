// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureFamilies_h
#define PictureFamilies_h

#include "Benchmarks/Approximations/Approximation.h"

/**
 * The questions of the suite `picture-errors`: frames against pictures in double precision.
 */
namespace approximations
{
/// The order of tetrahedra, on both paths, beside vtkProjectedTetrahedraMapper.
Family MakeSortFamily();
/// How tetrahedra are put together, against the picture in order of visibility.
Family MakeBlendFamily();

/// Volumes in time, projected, beside those of many time steps.
Family MakeTimeVolumeFamily();
/// The same where what is in them moves far from step to step.
Family MakeFastTimeVolumeFamily();

/// Light's buffer by its nearest texel or by four, at several sizes.
Family MakeLightLookupFamily();
/// Pixels of the viewport for each of the picture, beside vtkGPUVolumeRayCastMapper.
Family MakeImageSampleFamily();
/// Light of three channels through coloured matter, or of one.
Family MakeTransmissionFamily();
/// Types of scalars, whose textures round them.
Family MakeScalarTypeFamily();

/// Voxels of a painted flow, with and without PaintFilter.
Family MakeFlowVoxelFamily();
/// SampleDistance and MaximumPaintSamples.
Family MakeFlowSampleFamily();
/// Levels of vtkStreamlineTexture, beside those that OpenGL averages.
Family MakeStripeFamily();
}

#endif
