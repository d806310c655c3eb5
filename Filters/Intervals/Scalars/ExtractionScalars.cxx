// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/ExtractionScalars.h"

#include "Scalars/BitKernels.h"
#include "Scalars/ExtractionDispatch.h"
#include "Scalars/ExtractionKernels.h"
#include "Scalars/RowKernels.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;

template <typename T>
class Typed : public ExtractionScalars
{
public:
  Typed(const T* data, const ExtractionValues& values)
    : Typed(data, nullptr, std::numeric_limits<vtkIdType>::max(), values)
  {
  }

  Typed(const T* data, const T* second, vtkIdType split, const ExtractionValues& values)
    : Data(data)
    , Second(second)
    , Split(split)
    , Values(values)
    , Thresholds(values.GetThresholds<T>())
  {
    for (const double value : values.GetValues())
    {
      this->Isovalues.push_back(static_cast<Real>(value));
    }
  }

  bool Classify(vtkIdType first, vtkIdType number, Code* codes) const override
  {
    const T* f = this->Data + first;
    switch (this->Thresholds.size())
    {
      case 2:
        this->template Classify<2>(f, number, codes);
        break;
      case 4:
        this->template Classify<4>(f, number, codes);
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

  BitRows::Kinds Compare(vtkIdType first, vtkIdType number, const BitRows::Row& row) const override
  {
    // A threshold is missing if no value of type T is large enough to reach it.
    const std::size_t thresholds = this->Thresholds.size();
    const bool isReached = thresholds > 0;
    const bool isPassed = thresholds > 1;
    const T* const f = this->Data + first;
    const T reach = isReached ? this->Thresholds[0] : T();
    const T pass = isPassed ? this->Thresholds[1] : T();
    const auto isAbove = [=](T value) { return isReached & (value >= reach); };
    const auto isTie = [=](T value)
    { return isReached & (value >= reach) & !(isPassed & (value >= pass)); };
    BitRows::Kinds kinds;
    BitKernels::Fill(f, number, row.Above, isAbove);
    kinds.Ties = BitKernels::HasAny(f, number, isTie);
    if (kinds.Ties)
    {
      BitKernels::Fill(f, number, row.Ties, isTie);
    }
    if constexpr (std::is_floating_point<T>::value)
    {
      kinds.NonFinite = !RowKernels::AreFinite(f, number);
      if (kinds.NonFinite)
      {
        const auto isNonFinite = [](T value) { return !std::isfinite(value); };
        BitKernels::Fill(f, number, row.NonFinite, isNonFinite);
        BitKernels::Fill(
          f, number, row.Above, [=](T value) { return isNonFinite(value) | isAbove(value); });
      }
    }
    return kinds;
  }

  void Place(ExtractionPoint* points, vtkIdType number) const override
  {
    for (vtkIdType p = 0; p < number; ++p)
    {
      ExtractionPoint& point = points[p];
      if (point.Near != point.Far)
      {
        this->Place(point, this->Isovalues[static_cast<std::size_t>(point.Weight)]);
      }
    }
  }

private:
  // 64-bit integers need the 64-bit mantissa of long double, where available.
  using Real = typename std::conditional<std::is_integral<T>::value && sizeof(T) == 8, long double,
    double>::type;

  template <int N>
  void Classify(const T* f, vtkIdType number, Code* codes) const
  {
    if constexpr (std::is_floating_point<T>::value)
    {
      RowKernels::Classify(f, number, this->Thresholds.data(), N, codes);
    }
    else
    {
      ExtractionKernels::Classify<N>(f, number, this->Thresholds.data(), codes);
    }
  }

  T GetValue(vtkIdType point) const
  {
    return point < this->Split ? this->Data[point] : this->Second[point - this->Split];
  }

  static bool IsHalvingExact(T value)
  {
    return std::is_integral<T>::value || sizeof(T) < sizeof(double) ||
      std::abs(static_cast<double>(value)) > 1e-290;
  }

  void Place(ExtractionPoint& point, Real value) const
  {
    const T a = this->GetValue(point.Near);
    const T b = this->GetValue(point.Far);
    // Values are halved to avoid overflow, since they may span the full range of the type.
    const Real half = IsHalvingExact(a) && IsHalvingExact(b) ? Real(0.5) : Real(1.0);
    // Signed differences between the isovalue and the values at the two ends.
    const Real toA = value * half - static_cast<Real>(a) * half;
    const Real toB = static_cast<Real>(b) * half - value * half;
    // Branchless, since the closer end is unpredictable.
    const bool isNearA = std::abs(toA) <= std::abs(toB);
    const vtkIdType exchange = isNearA ? 0 : point.Near ^ point.Far;
    point.Near ^= exchange;
    point.Far ^= exchange;
    const Real to[2] = { toB, toA };
    point.Weight = static_cast<double>(to[isNearA] / (toA + toB));
  }

  bool MarkNonFinite(const T* f, vtkIdType number, Code* codes) const
  {
    if constexpr (std::is_floating_point<T>::value)
    {
      if (!RowKernels::AreFinite(f, number))
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
  const T* Second;
  vtkIdType Split;
  const ExtractionValues& Values;
  std::vector<T> Thresholds;
  std::vector<Real> Isovalues;
};

// Treats the values at marked points as NaN.
class Masked : public ExtractionScalars
{
public:
  Masked(std::unique_ptr<ExtractionScalars> scalars, Code nonFiniteCode, const unsigned char* marks)
    : Scalars(std::move(scalars))
    , NonFiniteCode(nonFiniteCode)
    , Marks(marks)
  {
  }

  bool Classify(vtkIdType first, vtkIdType number, Code* codes) const override
  {
    bool areFinite = this->Scalars->Classify(first, number, codes);
    for (vtkIdType i = 0; i < number; ++i)
    {
      if (this->Marks[first + i] != 0)
      {
        codes[i] = this->NonFiniteCode;
        areFinite = false;
      }
    }
    return areFinite;
  }

  BitRows::Kinds Compare(vtkIdType first, vtkIdType number, const BitRows::Row& row) const override
  {
    BitRows::Kinds kinds = this->Scalars->Compare(first, number, row);
    for (vtkIdType i = 0; i < number; ++i)
    {
      if (this->Marks[first + i] != 0)
      {
        const vtkIdType word = i / BitRows::BitsOfWord;
        const BitRows::Word bit = BitRows::Word(1) << (i % BitRows::BitsOfWord);
        row.NonFinite[word] |= bit;
        row.Above[word] |= bit;
        row.Ties[word] &= ~bit;
        kinds.NonFinite = true;
      }
    }
    return kinds;
  }

  void Place(ExtractionPoint* points, vtkIdType number) const override
  {
    this->Scalars->Place(points, number);
  }

private:
  std::unique_ptr<ExtractionScalars> Scalars;
  Code NonFiniteCode;
  const unsigned char* Marks;
};

// Reads two arrays of different types as double.
class Converted : public Typed<double>
{
public:
  Converted(vtkSmartPointer<vtkDataArray> first, vtkSmartPointer<vtkDataArray> second,
    vtkIdType split, const ExtractionValues& values)
    : Typed<double>(static_cast<const double*>(first->GetVoidPointer(0)),
        static_cast<const double*>(second->GetVoidPointer(0)), split, values)
    , Arrays{ first, second }
  {
  }

private:
  vtkSmartPointer<vtkDataArray> Arrays[2];
};
}

std::unique_ptr<ExtractionScalars> ExtractionScalars::Make(
  vtkDataArray* scalars, const ExtractionValues& values, const unsigned char* nonFinite)
{
  std::unique_ptr<ExtractionScalars> result;
  ExtractionDispatch::Execute(scalars,
    [&](const auto* data)
    {
      using T = std::decay_t<decltype(*data)>;
      result = std::make_unique<Typed<T>>(data, values);
      return true;
    });
  if (nonFinite)
  {
    result = std::make_unique<Masked>(std::move(result), values.GetNonFiniteCode(), nonFinite);
  }
  return result;
}

std::unique_ptr<ExtractionScalars> ExtractionScalars::MakePair(
  vtkDataArray* first, vtkDataArray* second, vtkIdType split, const ExtractionValues& values)
{
  if (first->GetDataType() != second->GetDataType())
  {
    return std::make_unique<Converted>(ExtractionDispatch::MakeCopy(first, VTK_DOUBLE),
      ExtractionDispatch::MakeCopy(second, VTK_DOUBLE), split, values);
  }
  std::unique_ptr<ExtractionScalars> result;
  ExtractionDispatch::Execute(first,
    [&](const auto* data)
    {
      using T = std::decay_t<decltype(*data)>;
      result = std::make_unique<Typed<T>>(
        data, static_cast<const T*>(second->GetVoidPointer(0)), split, values);
      return true;
    });
  return result;
}

}
