// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScatteringModes_h
#define ScatteringModes_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Support/Pictures/ShadowScene.h"

#include <functional>
#include <string>
#include <vector>

class vtkShadowedSliceMapper;

/**
 * What the suite `scattering` measures.
 */
namespace scattering
{
extern const char* const Single;
extern const char* const Forward;
extern const char* const Full;
extern const char* const MonteCarlo;

/// The three modes, as the rows name them.
std::vector<std::string> GetModes();

using Change = std::function<void(vtkShadowedSliceMapper*)>;

/// Sets the mode of that name with Henyey and Greenstein's phase function, then what \a more says.
Change InMode(const std::string& mode, double g, const Change& more = nullptr);

/// A frame of \a method in which the light, too, has moved on by half a degree, so that scattered
/// light is found anew; it belongs to the scene of the method.
BenchWork GetLitFrame(shadows::Method& method, vtkLight* light, int threads);
}

#endif
