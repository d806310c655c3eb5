// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionPoint_h
#define interlume_ExtractionPoint_h

#include "vtkType.h"

namespace interlume
{

/**
 * The origin of an output point: a grid point when Near equals Far, else the point at Weight of the
 * way from Near to Far, Weight <= 1/2 since Near is the end nearer the isovalue.
 */
struct ExtractionPoint
{
  vtkIdType Near;
  vtkIdType Far;
  double Weight;
};

}

#endif
