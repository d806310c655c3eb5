// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MeshingJob_h
#define interlume_MeshingJob_h

#include "Mesh/Tetrahedra.h"
#include "TetGen/TetGenProcess.h"
#include "TetGen/TetrahedralMesherReport.h"

#include "vtkMeshingSettings.h"

#include <functional>
#include <string>

class vtkDataSet;

namespace interlume
{

/**
 * One execution of vtkTetrahedralMesher: its settings, its means, and its results. A mesher fills
 * Mesh, or returns an error. A canceled job has no error, and Mesh is of no use.
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
  TetrahedralMesherReport Report;

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

  /// Runs TetGen, and counts the call. Returns an error if there is no solution. A canceled run has
  /// no error.
  Error Solve(const TetGenProblem& problem, TetGenSolution& solution);
};

}

#endif
