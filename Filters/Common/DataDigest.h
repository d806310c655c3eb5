// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DataDigest_h
#define interlume_DataDigest_h

#include "Common/GridCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include "vtksys/MD5.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace interlume
{

/**
 * @class   DataDigest
 * @brief   MD5 digest of numbers, arrays and datasets
 *
 * The digest of an array includes its type, number of components, number of tuples and the bytes of
 * its values. Values of arrays without the standard memory layout are converted to double.
 */
class DataDigest
{
public:
  DataDigest() { vtksysMD5_Initialize(this->Md5.get()); }

  void Add(const void* bytes, std::size_t number)
  {
    const auto* at = static_cast<const unsigned char*>(bytes);
    while (number > 0)
    {
      // vtksysMD5_Append takes an int; a negative length would mean a null-terminated string.
      const std::size_t part = std::min<std::size_t>(number, std::numeric_limits<int>::max());
      vtksysMD5_Append(this->Md5.get(), at, static_cast<int>(part));
      at += part;
      number -= part;
    }
  }

  void Add(const std::string& text)
  {
    // The terminating null is included so that successive strings do not merge.
    this->Add(text.c_str(), text.size() + 1);
  }

  /// Adds an array. The digest of null differs from that of every array.
  void Add(vtkDataArray* array)
  {
    const vtkIdType shape[3] = { array ? array->GetDataType() : -1,
      array ? array->GetNumberOfComponents() : 0, array ? array->GetNumberOfTuples() : 0 };
    this->Add(shape, sizeof(shape));
    if (!array || array->GetNumberOfValues() == 0)
    {
      return;
    }
    if (array->HasStandardMemoryLayout())
    {
      this->Add(array->GetVoidPointer(0),
        static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
      return;
    }
    std::vector<double> tuple(static_cast<std::size_t>(array->GetNumberOfComponents()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      array->GetTuple(i, tuple.data());
      this->Add(tuple.data(), tuple.size() * sizeof(double));
    }
  }

  void Add(vtkPoints* points) { this->Add(points ? points->GetData() : nullptr); }

  void Add(vtkCellArray* cells)
  {
    this->Add(cells ? cells->GetOffsetsArray() : nullptr);
    this->Add(cells ? cells->GetConnectivityArray() : nullptr);
  }

  /// Adds points, polygons, strips, lines and texture coordinates. The digest of null differs from
  /// that of every surface.
  void Add(vtkPolyData* surface)
  {
    this->Add(surface ? surface->GetPoints() : nullptr);
    this->Add(surface ? surface->GetPolys() : nullptr);
    this->Add(surface ? surface->GetStrips() : nullptr);
    this->Add(surface ? surface->GetLines() : nullptr);
    this->Add(surface ? surface->GetPointData()->GetTCoords() : nullptr);
  }

  /// Adds the class, geometry and ghost arrays of a dataset, and the cells and faces of polyhedra
  /// if it is an unstructured grid. Does nothing if \a grid is null.
  void AddGrid(vtkDataSet* grid)
  {
    if (!grid)
    {
      return;
    }
    this->Add(std::string(grid->GetClassName()));
    if (auto* image = vtkImageData::SafeDownCast(grid))
    {
      this->Add(image->GetExtent(), 6 * sizeof(int));
      this->Add(image->GetOrigin(), 3 * sizeof(double));
      this->Add(image->GetSpacing(), 3 * sizeof(double));
      this->Add(image->GetDirectionMatrix()->GetData(), 9 * sizeof(double));
    }
    else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(grid))
    {
      this->Add(rectilinear->GetExtent(), 6 * sizeof(int));
      this->Add(rectilinear->GetXCoordinates());
      this->Add(rectilinear->GetYCoordinates());
      this->Add(rectilinear->GetZCoordinates());
    }
    else if (auto* set = vtkPointSet::SafeDownCast(grid))
    {
      this->Add(set->GetPoints());
    }
    if (auto* structured = vtkStructuredGrid::SafeDownCast(grid))
    {
      this->Add(structured->GetExtent(), 6 * sizeof(int));
    }
    if (auto* unstructured = vtkUnstructuredGrid::SafeDownCast(grid))
    {
      this->Add(GridCells::GetStoredTypes(unstructured));
      this->Add(unstructured->GetCells());
      for (auto* faces : GridCells::GetFaceArrays(unstructured))
      {
        if (faces)
        {
          this->Add(faces);
        }
      }
    }
    this->Add(grid->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
    this->Add(grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  }

  /// Returns the digest of all added data as 32 hexadecimal digits, and starts a new digest.
  std::string Take()
  {
    std::string digest(32, '0');
    vtksysMD5_FinalizeHex(this->Md5.get(), &digest[0]);
    vtksysMD5_Initialize(this->Md5.get());
    return digest;
  }

private:
  std::unique_ptr<vtksysMD5, void (*)(vtksysMD5*)> Md5{ vtksysMD5_New(), vtksysMD5_Delete };
};

}

#endif
