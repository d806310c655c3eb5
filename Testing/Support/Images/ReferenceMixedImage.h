// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMixedImage_h
#define ReferenceMixedImage_h

#include "Support/Images/RgbaImage.h" // for the image

namespace reference
{

struct MixedScene;

/**
 * Renders volumes as documented for vtkShadowedSliceMapper, and surfaces with VTK's shading.
 * Volumes and surfaces cast shadows on themselves and on each other. Marches along the view ray of
 * each pixel, and from each point on it toward every sample point of the lights that cast shadows.
 * All computations are in double precision.
 *
 * Steps end at the planes through samples, at cropping and clipping planes, and at surfaces, or at
 * an optical depth of 0.1. Each step is integrated with the two-point Gauss rule. The lengths of
 * all steps are divided by \a refinement. The difference from the image with twice the refinement
 * is an estimate of the error. The near and far planes of the camera clip the scene. Rows are
 * computed in parallel, and the result is independent of the number of threads.
 *
 * Throws std::invalid_argument if ReferenceMedium or ReferenceSurface does.
 */
RgbaImage MakeMixedImage(const MixedScene& scene, int refinement = 1);

}

#endif
