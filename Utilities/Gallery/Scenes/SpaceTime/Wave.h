// SPDX-License-Identifier: BSD-3-Clause
#ifndef Wave_h
#define Wave_h

#include "vtkSmartPointer.h"

class vtkAnalyticFieldSource;

namespace gallery
{
/**
 * The source's test function, a travelling wave, on its 40 x 20 x 20 points at times 0 and 1.
 */
vtkSmartPointer<vtkAnalyticFieldSource> MakeWave();
}

#endif
