// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/ArrayInterpolator.h"

#include "Output/Interpolation.h"
#include "Scalars/ExtractionDispatch.h"

#include "vtkDataArray.h"

namespace interlume
{

namespace
{
// Contiguous values.
template <typename T>
struct Contiguous
{
  const T* Values;

  double Get(vtkIdType point, int component, int components) const
  {
    return static_cast<double>(this->Values[point * components + component]);
  }
};

// Values of an array of any type, read with GetComponent().
struct AnyValues
{
  vtkDataArray* Values;

  double Get(vtkIdType point, int component, int) const
  {
    return this->Values->GetComponent(point, component);
  }
};

// Values of two arrays. Ids from Split on refer to the second array.
template <typename Source>
struct Pair
{
  Source First;
  Source Second;
  vtkIdType Split;

  double Get(vtkIdType point, int component, int components) const
  {
    return point < this->Split ? this->First.Get(point, component, components)
                               : this->Second.Get(point - this->Split, component, components);
  }
};

template <typename Source, typename Out>
class Typed : public ArrayInterpolator
{
public:
  Typed(const Source& in, int components)
    : In(in)
    , Components(components)
  {
  }

  void Interpolate(const ExtractionPoint* points, std::size_t number, void* out) const override
  {
    Out* const values = static_cast<Out*>(out);
    // With a number of components known at compile time, the compiler unrolls the loop over them.
    switch (this->Components)
    {
      case 1:
        return this->template Run<1>(points, number, values);
      case 3:
        return this->template Run<3>(points, number, values);
      default:
        return this->template Run<0>(points, number, values);
    }
  }

private:
  template <int Known>
  void Run(const ExtractionPoint* points, std::size_t number, Out* value) const
  {
    const int size = Known ? Known : this->Components;
    for (std::size_t p = 0; p < number; ++p)
    {
      const ExtractionPoint& point = points[p];
      for (int c = 0; c < size; ++c)
      {
        *value++ = Interpolation::Between<Out>(
          this->In.Get(point.Near, c, size), this->In.Get(point.Far, c, size), point.Weight);
      }
    }
  }

  Source In;
  int Components;
};

template <typename Source>
std::unique_ptr<ArrayInterpolator> MakeTyped(const Source& source, int components, int outType)
{
  if (outType == VTK_FLOAT)
  {
    return std::make_unique<Typed<Source, float>>(source, components);
  }
  return std::make_unique<Typed<Source, double>>(source, components);
}
}

std::unique_ptr<ArrayInterpolator> ArrayInterpolator::Make(
  vtkDataArray* first, vtkDataArray* second, vtkIdType split, int outType)
{
  // Two steps may share an array, but their points have different ids.
  const bool isSingle = first == second && split == VTK_ID_MAX;
  const int components = first->GetNumberOfComponents();
  std::unique_ptr<ArrayInterpolator> made;
  ExtractionDispatch::Execute(first,
    [&](const auto* values)
    {
      using T = std::decay_t<decltype(*values)>;
      using Source = Contiguous<T>;
      auto* other = vtkAOSDataArrayTemplate<T>::FastDownCast(second);
      if (isSingle)
      {
        made = MakeTyped(Source{ values }, components, outType);
      }
      else if (other)
      {
        made = MakeTyped(
          Pair<Source>{ { values }, { other->GetPointer(0) }, split }, components, outType);
      }
      return true;
    });
  if (!made)
  {
    made = isSingle
      ? MakeTyped(AnyValues{ first }, components, outType)
      : MakeTyped(Pair<AnyValues>{ { first }, { second }, split }, components, outType);
  }
  return made;
}

}
