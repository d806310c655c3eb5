// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DistributedSamples_h
#define interlume_DistributedSamples_h

#include "vtkSmartPointer.h"

class vtkDataSet;

namespace interlume
{

class DistributedField;

/**
 * Samples at points of a distributed field.
 */
namespace DistributedSamples
{
/**
 * Creates in each process all the samples that SampleGrid::Make creates for a rectilinear or
 * structured grid with many points. Collective.
 *
 * The process that owns a point sends the point and its arrays.
 */
vtkSmartPointer<vtkDataSet> Make(DistributedField& field);
}

}

#endif
