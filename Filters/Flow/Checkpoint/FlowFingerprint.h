// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowFingerprint_h
#define interlume_FlowFingerprint_h

#include "Common/Fingerprint.h"

class vtkDataArray;
class vtkDataSet;

namespace interlume
{

struct AdvectionOptions;

/**
 * @class   FlowFingerprint
 * @brief   fingerprint of everything that determines the streamlines of a vtkImplicitFlowField
 *
 * Settings are stored as text, data as digests. The data are the grid, its vectors, the averaged
 * arrays and the samples. Termination surfaces are described by their PrintSelf output and by
 * digests of their meshes and lines.
 */
class FlowFingerprint : public Fingerprint
{
public:
  /// Computes the fingerprint of an execution. Averaged arrays may be missing from \a field.
  FlowFingerprint(
    const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors, vtkDataSet* samples);
};

}

#endif
