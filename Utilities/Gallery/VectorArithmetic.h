// SPDX-License-Identifier: BSD-3-Clause
#ifndef VectorArithmetic_h
#define VectorArithmetic_h

/**
 * @file
 * @brief + - * / for vtkVector3d and its like
 *
 * They are in a header of their own in VTK 9.1 to 9.5, and in vtkVector.h itself from 9.6 on.
 */
#include "vtkVector.h"
#if __has_include("vtkVectorOperators.h")
#include "vtkVectorOperators.h"
#endif

#endif
