// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshingJob_h
#define interlume_MeshingJob_h

#include "Mesh/Tetrahedra.h"
#include "TetGen/TetGenProcess.h"

#include "vtkMeshingSettings.h"
#include "vtkTetrahedralMesherReport.h"

#include <functional>
#include <string>

class vtkDataSet;

namespace interlume
{

/**
 * One execution of vtkTetrahedralMesher: its settings, its means, and its results. A mesher fills
 * Mesh, or returns why not; Mesh is of no use when it was cancelled, which is nothing wrong.
 */
struct MeshingJob : vtkMeshingSettings
{
  MeshingJob(const vtkMeshingSettings& settings, vtkDataSet* input)
    : vtkMeshingSettings(settings)
    , Input(input)
    , TetGen(settings.WorkerFileName)
  {
    this->TetGen.TimeLimit = settings.TimeLimit;
  }

  vtkDataSet* Input;
  std::function<void(double)> SetProgress;
  std::function<bool()> IsCancelled;
  TetGenProcess TetGen;

  Tetrahedra Mesh;
  vtkTetrahedralMesherReport Report;

  /// Sets the unit of length in which TetGen gets the points, see Tetrahedra::UnitExponent, and
  /// converts the volume bound.
  void SetUnit(int exponent);
  /// Returns whether the mesh is to be refined.
  bool IsRefining() const { return this->QualityBound > 0.0 || this->MaximumVolume > 0.0; }
  /// Returns TetGen's switches to refine a mesh to bounds, 0 for none, by at most \a points new
  /// ones.
  std::string GetRefinementSwitches(double quality, double volume, int points) const;

  /// Returns the dimension of cells of a type; 0 for a type that is not known.
  static int GetDimension(int cellType);

  /// Runs TetGen, and counts the call. Returns why there is no solution, or nothing; nothing where
  /// it was cancelled, too.
  std::string Solve(const TetGenProblem& problem, TetGenSolution& solution);
};

}

#endif
