#ifndef vtkExtractionScalars_h
#define vtkExtractionScalars_h

#include "vtkExtractionContext.h"
#include "vtkExtractionKernels.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

/**
 * @class   vtkExtractionScalars
 * @brief   codes and edge weights from scalars of one type
 */
template <typename T>
class vtkExtractionScalars
{
public:
  using Code = vtkExtractionValues::Code;

  vtkExtractionScalars(const T* data, const vtkExtractionValues& values)
    : Data(data)
    , Values(values)
    , Thresholds(values.GetThresholds<T>())
  {
  }

  T GetValue(vtkIdType point) const { return this->Data[point]; }

  /// The codes of points first ... first + number - 1. Returns whether all are finite.
  bool Classify(vtkIdType first, vtkIdType number, Code* codes) const
  {
    const T* f = this->Data + first;
    switch (this->Thresholds.size())
    {
      case 2:
        vtkExtractionKernels::Classify<2>(f, number, this->Thresholds.data(), codes);
        break;
      case 4:
        vtkExtractionKernels::Classify<4>(f, number, this->Thresholds.data(), codes);
        break;
      default:
        std::fill(codes, codes + number, Code(0));
        for (const T threshold : this->Thresholds)
        {
          for (vtkIdType i = 0; i < number; ++i)
          {
            codes[i] = static_cast<Code>(codes[i] + (f[i] >= threshold));
          }
        }
    }
    return this->MarkNonFinite(f, number, codes);
  }

  /// The point where isovalue number \a k crosses the edge of a < b.
  vtkExtractionPoint Cross(vtkIdType a, vtkIdType b, int k) const
  {
    const Real value = static_cast<Real>(this->Values.GetValues()[k]);
    // Halved, since the range may be the whole of the type's.
    const Real fa = static_cast<Real>(this->Data[a]) * Real(0.5);
    const Real fb = static_cast<Real>(this->Data[b]) * Real(0.5);
    if (!IsHalvingExact(this->Data[a]) || !IsHalvingExact(this->Data[b]))
    {
      return this->Place(a, b, value - this->Data[a], this->Data[b] - value);
    }
    return this->Place(a, b, value * Real(0.5) - fa, fb - value * Real(0.5));
  }

private:
  // 64-bit integers need the 64-bit mantissa of long double, where it has one.
  using Real = typename std::conditional<std::is_integral<T>::value && sizeof(T) == 8, long double,
    double>::type;

  static bool IsHalvingExact(T value)
  {
    return std::is_integral<T>::value || sizeof(T) < sizeof(double) ||
      std::abs(static_cast<double>(value)) > 1e-290;
  }

  // toA and toB: signed distances in value from the isovalue to the ends.
  static vtkExtractionPoint Place(vtkIdType a, vtkIdType b, Real toA, Real toB)
  {
    const Real whole = toA + toB;
    if (std::abs(toA) <= std::abs(toB))
    {
      return { a, b, static_cast<double>(toA / whole) };
    }
    return { b, a, static_cast<double>(toB / whole) };
  }

  bool MarkNonFinite(const T* f, vtkIdType number, Code* codes) const
  {
    if constexpr (std::is_floating_point<T>::value)
    {
      int nonFinite = 0;
      for (vtkIdType i = 0; i < number; ++i)
      {
        nonFinite |= !(std::abs(f[i]) <= std::numeric_limits<T>::max());
      }
      if (nonFinite)
      {
        for (vtkIdType i = 0; i < number; ++i)
        {
          if (!std::isfinite(f[i]))
          {
            codes[i] = this->Values.GetNonFiniteCode();
          }
        }
        return false;
      }
    }
    return true;
  }

  const T* Data;
  const vtkExtractionValues& Values;
  std::vector<T> Thresholds;
};

#endif
