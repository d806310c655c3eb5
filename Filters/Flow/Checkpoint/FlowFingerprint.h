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
 * @brief   all that the streamlines of an execution of vtkImplicitFlowField depend on
 *
 * Settings are written out, data are digests: the field, its vectors, the arrays that means are
 * taken of, the samples, and the termination surfaces, by what they print of themselves and by the
 * meshes and lines that they have.
 */
class FlowFingerprint : public Fingerprint
{
public:
  /// Makes that of an execution; an array that a mean is to be taken of may be missing.
  FlowFingerprint(
    const AdvectionOptions& options, vtkDataSet* field, vtkDataArray* vectors, vtkDataSet* samples);
};

}

#endif
