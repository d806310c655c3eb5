// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeVaryingNumbers_h
#define TimeVaryingNumbers_h

#include <nlohmann/json.hpp>

/**
 * Time-varying interval volumes and slices of them: a list of what was asked, as
 * MakeTimeVaryingVolume takes it, with `slice_times` and the measures of what came out,
 * `tetrahedra`, `boundaries`, `simplices` and `slices`.
 * @throw std::runtime_error when an output is empty.
 */
nlohmann::json MeasureTimeVaryingVolumes();

#endif
