// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExplicitFlowVolume_h
#define ExplicitFlowVolume_h

#include "Benchmarks/Flow/FlowDisc.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

/**
 * The explicit flow volume of a disc, in the manner of N. Max, B. Becker and R. Crawfis, "Flow
 * volumes for interactive vector field visualization", IEEE Visualization 1993: a patch of
 * triangles is carried along the field, and each triangle sweeps out prisms from layer to layer,
 * which are cut into tetrahedra.
 *
 * Streamlines by vtkRungeKutta4 in equal steps of at most half a cell, through
 * VTK's interpolation; one that leaves the field stays where it was. Where neighbours part
 * further than LongestEdge anywhere, the edge between them is halved on the disc, and a new
 * streamline begins there: from the first layer on, other than there, so that layers meet.
 */
class ExplicitFlowVolume
{
public:
  struct Settings
  {
    /// Rings of triangles around the middle of the disc.
    int Rings = 8;
    int Layers = 32;
    /// World units; 0: none is halved.
    double LongestEdge = 0.0;
    /// How often edges are halved at most.
    int MostHalvings = 5;
  };

  ExplicitFlowVolume(
    vtkImageData* field, const flow::Disc& disc, double time, const Settings& settings);

  /// Tetrahedra, right-handed where the flow carries triangles without turning them over.
  vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra() const;
  /// Calls \a visit with the corners of each triangle that the circle around the disc sweeps out.
  template <typename Visitor>
  void ForEachSide(const Visitor& visit) const;

  std::size_t GetNumberOfStreamlines() const { return this->Streamlines.size(); }

private:
  using Vector = std::array<double, 3>;
  using Triangle = std::array<vtkIdType, 3>;
  using Edge = std::pair<vtkIdType, vtkIdType>;

  void MakePatch();
  void Trace();
  /// The edges, lower id first, and how many triangles they have.
  std::map<Edge, int> GetEdges() const;
  /// Halves edges that are too long somewhere; false if none is.
  bool Refine();
  /// The triangle's parts, with the new points in the middle of its edges, -1 without.
  static void Split(
    const Triangle& triangle, const Triangle& middles, std::vector<Triangle>& parts);

  vtkSmartPointer<vtkImageData> Field;
  flow::Disc Inflow;
  double Time;
  Settings Options;
  std::vector<Triangle> Patch;
  /// Of each point of the patch: its place on each layer.
  std::vector<std::vector<Vector>> Streamlines;
};

template <typename Visitor>
void ExplicitFlowVolume::ForEachSide(const Visitor& visit) const
{
  for (const auto& edge : this->GetEdges())
  {
    if (edge.second != 1)
    {
      continue;
    }
    const auto& a = this->Streamlines[static_cast<std::size_t>(edge.first.first)];
    const auto& b = this->Streamlines[static_cast<std::size_t>(edge.first.second)];
    for (std::size_t layer = 0; layer + 1 < a.size(); ++layer)
    {
      visit(a[layer], b[layer], b[layer + 1]);
      visit(a[layer], b[layer + 1], a[layer + 1]);
    }
  }
}

#endif
