// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/ExplicitFlowVolume.h"

#include "Benchmarks/Flow/VelocityInterpolation.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRungeKutta4.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;
}

ExplicitFlowVolume::ExplicitFlowVolume(
  vtkImageData* field, const flow::Disk& disk, double time, const Settings& settings)
  : Field(field)
  , Inflow(disk)
  , Time(time)
  , Options(settings)
{
  this->MakePatch();
  this->Trace();
}

void ExplicitFlowVolume::MakePatch()
{
  this->Streamlines.push_back({ { { this->Inflow.X, this->Inflow.Y, this->Inflow.Z } } });
  // Returns the id of a point of a ring. Ring 0 is the center, and ring k has 6 k points.
  const auto getPoint = [](int ring, int at) -> vtkIdType
  { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + at % (6 * ring); };
  for (int ring = 1; ring <= this->Options.Rings; ++ring)
  {
    const double radius = this->Inflow.Radius * ring / this->Options.Rings;
    for (int at = 0; at < 6 * ring; ++at)
    {
      const double angle = Pi * at / (3 * ring);
      this->Streamlines.push_back({ { { this->Inflow.X, this->Inflow.Y + radius * std::cos(angle),
        this->Inflow.Z + radius * std::sin(angle) } } });
      const int sector = at / ring;
      const int inner = at - sector;
      this->Patch.push_back(
        { { getPoint(ring, at), getPoint(ring, at + 1), getPoint(ring - 1, inner) } });
      if (at % ring != 0)
      {
        this->Patch.push_back(
          { { getPoint(ring - 1, inner - 1), getPoint(ring, at), getPoint(ring - 1, inner) } });
      }
    }
  }
}

void ExplicitFlowVolume::Trace()
{
  const auto field = flow::NewInterpolator(flow::CellSearch::CLOSEST_POINT, this->Field);
  vtkDataArray* vectors = this->Field->GetPointData()->GetVectors();
  vtkNew<vtkRungeKutta4> integrator;
  integrator->SetFunctionSet(field);
  const double* spacing = this->Field->GetSpacing();
  const double halfCell = 0.5 * std::min(std::min(spacing[0], spacing[1]), spacing[2]);
  const double layer = this->Time / this->Options.Layers;
  const int steps =
    std::max(1, static_cast<int>(std::ceil(layer * vectors->GetMaxNorm() / halfCell)));
  for (std::vector<Vector>& positions : this->Streamlines)
  {
    while (positions.size() <= static_cast<std::size_t>(this->Options.Layers))
    {
      Vector position = positions.back();
      for (int step = 0; step < steps; ++step)
      {
        double time = layer / steps;
        double error = 0.0;
        Vector next;
        if (integrator->ComputeNextStep(
              position.data(), next.data(), 0.0, time, 0.0, error, nullptr) != 0)
        {
          break;
        }
        position = next;
      }
      positions.push_back(position);
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> ExplicitFlowVolume::MakeTetrahedra() const
{
  const auto layers = static_cast<vtkIdType>(this->Options.Layers) + 1;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Streamlines.size()) * layers);
  vtkIdType id = 0;
  for (const std::vector<Vector>& streamline : this->Streamlines)
  {
    for (const Vector& position : streamline)
    {
      points->SetPoint(id++, position.data());
    }
  }
  vtkNew<vtkCellArray> cells;
  for (Triangle triangle : this->Patch)
  {
    // Split prisms by the order of point ids only, so that neighbors split their common face in the
    // same way.
    const int inversions = (triangle[0] > triangle[1] ? 1 : 0) +
      (triangle[1] > triangle[2] ? 1 : 0) + (triangle[0] > triangle[2] ? 1 : 0);
    std::sort(triangle.begin(), triangle.end());
    for (vtkIdType layer = 0; layer + 1 < layers; ++layer)
    {
      vtkIdType low[3];
      vtkIdType high[3];
      for (std::size_t i = 0; i < 3; ++i)
      {
        low[i] = triangle[i] * layers + layer;
        high[i] = low[i] + 1;
      }
      vtkIdType tetrahedra[3][4] = { { low[0], low[1], low[2], high[2] },
        { low[0], low[1], high[2], high[1] }, { low[0], high[1], high[2], high[0] } };
      for (vtkIdType* tetrahedron : tetrahedra)
      {
        if (inversions % 2 == 1)
        {
          std::swap(tetrahedron[0], tetrahedron[1]);
        }
        cells->InsertNextCell(4, tetrahedron);
      }
    }
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(VTK_TETRA, cells);
  return grid;
}
