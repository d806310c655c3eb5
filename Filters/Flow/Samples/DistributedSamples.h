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
 * Creates in every process the samples that SampleGrid::Make() would create for the full grid,
 * which must not be an image. Collective.
 *
 * For structured data, the process that owns a sampled point sends its position and array values.
 */
vtkSmartPointer<vtkDataSet> Make(DistributedField& field);
}

}

#endif
