// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInflowMappingReport_h
#define vtkInflowMappingReport_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkIndent.h"
#include "vtkType.h"

#include <ostream>

/**
 * @class   vtkInflowMappingReport
 * @brief   what an execution of vtkInflowMapping mapped
 *
 * @sa vtkInflowMapping
 */
struct INTERLUMEFLOW_EXPORT vtkInflowMappingReport
{
  /// The numbers of samples, and of ids in use.
  vtkIdType Samples = 0;
  vtkIdType Ids = 0;
  /// The number of seams of u and v that the mappings go on over.
  vtkIdType ContinuedSeams = 0;

  void Print(std::ostream& os, vtkIndent indent) const;
};

#endif
