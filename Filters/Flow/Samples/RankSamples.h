// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RankSamples_h
#define interlume_RankSamples_h

#include "vtkSmartPointer.h"

class vtkDataSet;

namespace interlume
{

class RankField;

/**
 * Samples that are points of a field which processes hold in parts.
 */
namespace RankSamples
{
/**
 * Makes the samples that SampleGrid::Make makes of a rectilinear or structured grid of many points,
 * all of them in each process. Collective.
 *
 * Each point and its arrays are sent by the process that counts it, as they are.
 */
vtkSmartPointer<vtkDataSet> Make(RankField& field);
}

}

#endif
