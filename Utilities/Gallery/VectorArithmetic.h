// SPDX-License-Identifier: BSD-3-Clause
#ifndef VectorArithmetic_h
#define VectorArithmetic_h

/**
 * @file
 * @brief + - * / for vtkVector3d and similar types
 *
 * VTK 9.1 to 9.5 declare these operators in a separate header, VTK 9.6 in vtkVector.h.
 */
#include "vtkVector.h"
#if __has_include("vtkVectorOperators.h")
#include "vtkVectorOperators.h"
#endif

#endif
