// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowStatus.h"

const char* vtkFlowStatus::GetName(int status)
{
  switch (status)
  {
    case REACHED_SURFACE:
      return "reached surface";
    case LEFT_DOMAIN:
      return "left domain";
    case STAGNATED:
      return "stagnated";
    case OUT_OF_TIME:
      return "out of time";
    case OUT_OF_STEPS:
      return "out of steps";
    case OUTSIDE:
      return "outside";
    case NOT_FINITE:
      return "not finite";
    case CLOSED_ORBIT:
      return "closed orbit";
    default:
      return nullptr;
  }
}
