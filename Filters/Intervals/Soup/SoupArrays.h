// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoupArrays_h
#define interlume_SoupArrays_h

#include "Arrays/CarriedArrays.h"
#include "Output/ExtractionBuffer.h"
#include "Soup/SoupPart.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkPointData;
class vtkPoints;

namespace interlume
{

class SoupBuilder;

/**
 * @class   SoupArrays
 * @brief   coordinates and point arrays of triangles that share no points, made part by part
 *
 * They have the bytes that ExtractionArrays gives for the same points. A part is interpolated by
 * the thread that found its points, while these are in its cache, and written when its place is
 * known.
 */
class SoupArrays
{
public:
  /// Of a grid with points of its own; \a precision is one of vtkAlgorithm.
  SoupArrays(vtkDataSet* input, int precision);
  ~SoupArrays();

  /// Interpolates what has been collected. Any number of threads may do so at a time.
  SoupPart Interpolate(const SoupBuilder& builder) const;

  /// Makes room for \a corners points.
  void Allocate(vtkIdType corners);

  /// Writes the corners of a part from \a first on. Threads may write different parts at a time.
  void Write(SoupPart& part, vtkIdType first);

  /// Returns whether there is room.
  bool IsAllocated() const { return this->HasRoom; }
  const vtkSmartPointer<vtkPoints>& GetPoints() const { return this->Arrays.GetPoints(); }
  /// Gives the arrays to \a output.
  void AddTo(vtkPointData* output);

private:
  class Writer;
  template <typename Out>
  class TypedWriter;

  void AddWriter(vtkDataArray* in, vtkDataArray* out);

  CarriedArrays Arrays;
  std::vector<std::unique_ptr<Writer>> Writers;
  /// The numbers of components of all coordinates and arrays in single and in double precision.
  std::size_t FloatComponents = 0;
  std::size_t DoubleComponents = 0;
  /// The nearer end of each point, where there are arrays that are not of numbers.
  ExtractionBuffer<vtkIdType> Nearer;
  bool HasRoom = false;
};

}

#endif
