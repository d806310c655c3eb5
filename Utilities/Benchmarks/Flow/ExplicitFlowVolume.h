// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExplicitFlowVolume_h
#define ExplicitFlowVolume_h

#include "Benchmarks/Flow/FlowDisk.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cstddef>
#include <vector>

/**
 * Explicit flow volume of a disk, following N. Max, B. Becker and R. Crawfis, "Flow volumes for
 * interactive vector field visualization", IEEE Visualization 1993. A patch of triangles is
 * advected along the field. Each triangle sweeps out prisms from layer to layer, which are split
 * into tetrahedra.
 *
 * Streamlines are integrated by vtkRungeKutta4 in equal steps of at most half a cell, with VTK's
 * interpolation. A streamline that leaves the field stops at its last position.
 */
class ExplicitFlowVolume
{
public:
  struct Settings
  {
    /// Number of rings of triangles around the center of the disk.
    int Rings = 8;
    int Layers = 32;
  };

  ExplicitFlowVolume(
    vtkImageData* field, const flow::Disk& disk, double time, const Settings& settings);

  /// Returns the tetrahedra. Their volumes are positive unless the flow flips triangles.
  vtkSmartPointer<vtkUnstructuredGrid> MakeTetrahedra() const;
  std::size_t GetNumberOfStreamlines() const { return this->Streamlines.size(); }

private:
  using Vector = std::array<double, 3>;
  using Triangle = std::array<vtkIdType, 3>;

  void MakePatch();
  void Trace();

  vtkSmartPointer<vtkImageData> Field;
  flow::Disk Inflow;
  double Time;
  Settings Options;
  std::vector<Triangle> Patch;
  /// For each point of the patch, its positions in all layers.
  std::vector<std::vector<Vector>> Streamlines;
};

#endif
