// SPDX-License-Identifier: BSD-3-Clause
#ifndef Bonsai_h
#define Bonsai_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkSpatialObject.h"

namespace gallery
{
/**
 * Returns the scanned bonsai as an object: about 1.05 high, standing on z = 0, with its trunk near
 * the z axis. The scan cuts off the +y side of the pot. Noise in the air and the sheet under the
 * pot are excluded.
 */
vtkSmartPointer<vtkSpatialObject> MakeBonsai();

/// Returns the bonsai without a floor, for use with a polygonal ground, which has no steps between
/// voxels.
vtkSmartPointer<vtkImageData> SampleBonsai(int resolution);
}

#endif
