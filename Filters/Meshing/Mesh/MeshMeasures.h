// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshMeasures_h
#define interlume_MeshMeasures_h

#include "Common/Vectors.h"
#include "Mesh/TetrahedronMath.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace interlume
{

/**
 * Sizes and quality of tetrahedra, compared with a quality bound and a volume bound. A bound of 0
 * is not applied.
 */
struct MeshMeasures
{
  double QualityBound = 0.0;
  double MaximumVolume = 0.0;

  vtkIdType AboveQualityBound = 0;
  vtkIdType AboveMaximumVolume = 0;
  /// Total amount by which the tetrahedra exceed the bounds. For each bound that it exceeds, a
  /// tetrahedron adds its volume times the logarithm of the factor by which it exceeds the bound.
  double Excess = 0.0;
  double LargestRadiusEdgeRatio = 0.0;
  double SmallestVolume = std::numeric_limits<double>::infinity();
  double LargestVolume = 0.0;
  /// Minimum polar sine, see TetrahedronMath::PolarSine().
  double MinimumShape = std::numeric_limits<double>::infinity();

  template <typename Id>
  void Add(const std::vector<double>& points, const std::vector<Id>& tetrahedra)
  {
    for (std::size_t t = 0; t < tetrahedra.size(); t += 4)
    {
      this->Add(&points[3 * tetrahedra[t]], &points[3 * tetrahedra[t + 1]],
        &points[3 * tetrahedra[t + 2]], &points[3 * tetrahedra[t + 3]]);
    }
  }

private:
  void Add(const double* a, const double* b, const double* c, const double* d)
  {
    // An excess up to this fraction of a bound counts as rounding error.
    constexpr double rounding = 1e-9;
    const double volume = Vectors::SixVolumes(a, b, c, d) / 6.0;
    const double ratio = TetrahedronMath::RadiusEdgeRatio(a, b, c, d);
    const bool isBad = this->QualityBound > 0.0 && ratio > this->QualityBound * (1.0 + rounding);
    const bool isLarge =
      this->MaximumVolume > 0.0 && volume > this->MaximumVolume * (1.0 + rounding);
    this->AboveQualityBound += isBad;
    this->AboveMaximumVolume += isLarge;
    this->Excess += isBad ? volume * std::log(std::min(ratio / this->QualityBound, 1e9)) : 0.0;
    this->Excess += isLarge ? volume * std::log(volume / this->MaximumVolume) : 0.0;
    this->LargestRadiusEdgeRatio = std::max(this->LargestRadiusEdgeRatio, ratio);
    this->SmallestVolume = std::min(this->SmallestVolume, volume);
    this->LargestVolume = std::max(this->LargestVolume, volume);
    this->MinimumShape = std::min(this->MinimumShape, TetrahedronMath::PolarSine(a, b, c, d));
  }
};

}

#endif
