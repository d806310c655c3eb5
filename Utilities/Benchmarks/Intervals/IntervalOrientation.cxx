// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Data/BenchData.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Measures/TetrahedronSums.h"

#include "vtkIntervalVolume.h"

#include "vtkCellType.h"

namespace interval
{
namespace
{
void AddOrientationRow(const BenchData& data, BenchRows& rows)
{
  auto filter = methods::NewIntervalVolume(data.Data, data.Lower, data.Upper);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  const TetrahedronSums sums = SumTetrahedra(filter->GetOutput());
  BenchRow row = rows.Make(data.Case, "inverted");
  row.SetError("share of the volume", sums.GetInvertedVolumeFraction());
  row.Set({ { "cells", data.Data->GetNumberOfCells() }, { "tetrahedra", sums.Tetrahedra },
    { "inverted", sums.Inverted }, { "share", sums.GetInvertedFraction() } });
  rows.Add(row);
}

/**
 * Counts inverted tetrahedra in interval volumes of cells of each type with random scalars, and of
 * the cases of MakeSpeedCases(). The method is `inverted`, and the error is the fraction of the
 * volume that is in inverted tetrahedra.
 */
void AddOrientationRows(const BenchOptions& options, BenchRows& rows)
{
  const int cells = options.Pick(100000, 20000, 500);
  for (int type : { VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON })
  {
    AddOrientationRow(MakeRandomCells(type, cells, options.Seed), rows);
  }
  for (const BenchData& data : MakeSpeedCases(options))
  {
    AddOrientationRow(data, rows);
  }
}
}

BenchPart MakeOrientationPart()
{
  return { AddOrientationRows };
}
}
