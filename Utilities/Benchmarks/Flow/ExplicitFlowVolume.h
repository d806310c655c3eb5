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
#include <vector>

/**
 * The explicit flow volume of a disc, in the manner of N. Max, B. Becker and R. Crawfis, "Flow
 * volumes for interactive vector field visualization", IEEE Visualization 1993: a patch of
 * triangles is carried along the field, and each triangle sweeps out prisms from layer to layer,
 * which are cut into tetrahedra.
 *
 * Streamlines by vtkRungeKutta4 in equal steps of at most half a cell, through
 * VTK's interpolation; one that leaves the field stays where it was.
 */
class ExplicitFlowVolume
{
public:
  struct Settings
  {
    /// Rings of triangles around the middle of the disc.
    int Rings = 8;
    int Layers = 32;
  };

  ExplicitFlowVolume(
    vtkImageData* field, const flow::Disc& disc, double time, const Settings& settings);

  /// Tetrahedra, right-handed where the flow carries triangles without turning them over.
  vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra() const;
  std::size_t GetNumberOfStreamlines() const { return this->Streamlines.size(); }

private:
  using Vector = std::array<double, 3>;
  using Triangle = std::array<vtkIdType, 3>;

  void MakePatch();
  void Trace();

  vtkSmartPointer<vtkImageData> Field;
  flow::Disc Inflow;
  double Time;
  Settings Options;
  std::vector<Triangle> Patch;
  /// Of each point of the patch: its place on each layer.
  std::vector<std::vector<Vector>> Streamlines;
};

#endif
