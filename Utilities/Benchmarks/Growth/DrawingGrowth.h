// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawingGrowth_h
#define DrawingGrowth_h

#include "Benchmarks/Growth/GrowthQuantity.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"

namespace growth
{
///@{
/**
 * Memory is that of the first frame of a new mapper, time that of later ones, each after a small
 * turn: vtkTimeWeightedTetrahedraMapper against tetrahedra; vtkShadowedSliceMapper against slices,
 * and against lights that cast shadows, over the same picture without shadows.
 */
Quantity MakeTetrahedra(const BenchOptions& options, const tetrahedra::RenderPath& path);
Quantity MakeSlices(const BenchOptions& options);
Quantity MakeLights(const BenchOptions& options);
///@}
}

#endif
