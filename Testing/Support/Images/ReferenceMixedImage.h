// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMixedImage_h
#define ReferenceMixedImage_h

#include "Support/Images/RgbaImage.h" // for the image

namespace reference
{

struct MixedScene;

/**
 * Renders volumes as documented for vtkShadowedSliceMapper, and surfaces with VTK's shading.
 * Volumes and surfaces cast shadows on themselves and on each other. Marches in double precision
 * along the view ray of each pixel from surface to surface, and from each point toward every sample
 * point of the lights that cast shadows.
 *
 * Steps end at planes of samples, at cropping and clipping planes, at surfaces, and at an optical
 * depth of 0.1. Each step is integrated with the two-point Gauss rule. \a refinement divides the
 * length of all steps. The difference from the image with twice the refinement estimates the error.
 * The near and far planes of the camera clip the scene. Rows are computed in parallel, and the
 * result is independent of the number of threads.
 *
 * Throws std::invalid_argument like ReferenceMedium and ReferenceSurface.
 */
RgbaImage MakeMixedImage(const MixedScene& scene, int refinement = 1);

}

#endif
