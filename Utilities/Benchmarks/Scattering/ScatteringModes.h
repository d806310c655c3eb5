// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringModes_h
#define ScatteringModes_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Support/Images/ShadowScene.h"

#include <functional>
#include <string>
#include <vector>

class vtkShadowedSliceMapper;

/**
 * Scenes and methods of the suite `scattering`.
 */
namespace scattering
{
extern const char* const Single;
extern const char* const Forward;
extern const char* const Full;
extern const char* const MonteCarlo;

/// Returns the names of the three scattering modes, which are also the methods of rows.
std::vector<std::string> GetModes();

using Change = std::function<void(vtkShadowedSliceMapper*)>;

/// Returns a function that sets a mapper's scattering mode and a Henyey-Greenstein phase function
/// with anisotropy \a g, and then calls \a more.
Change MakeModeSetter(const std::string& mode, double g, const Change& more = nullptr);

/// Returns work that renders a frame of \a method after rotating the light by half a degree around
/// z, so that scattered light is computed again. The light must belong to the scene of \a method.
BenchWork MakeRelightingWork(shadows::Method& method, vtkLight* light, int threads);
}

#endif
