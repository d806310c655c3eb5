// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionPoint_h
#define interlume_ExtractionPoint_h

#include "vtkType.h"

namespace interlume
{

/**
 * Origin of an output point: a grid point if Near equals Far, otherwise the point at parameter
 * Weight on the edge from Near to Far. Near is the end closer to the point, so that Weight <= 1/2.
 */
struct ExtractionPoint
{
  vtkIdType Near;
  vtkIdType Far;
  double Weight;
};

}

#endif
