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
 * One execution of vtkTetrahedralMesher: its settings, its TetGen process, and its results. A
 * mesher fills Mesh or returns an error. A canceled job has no error, and its Mesh must not be
 * used.
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
  std::function<bool()> IsCanceled;
  TetGenProcess TetGen;

  Tetrahedra Mesh;
  TetrahedralMesherReport Report;

  /// Sets the unit of length in which TetGen receives the points, see Tetrahedra::UnitExponent, and
  /// converts the volume bound to it.
  void SetUnit(int exponent);
  /// Returns whether a bound is set.
  bool IsRefining() const { return this->QualityBound > 0.0 || this->MaximumVolume > 0.0; }
  /// Returns TetGen's switches for refinement with bounds (0 for no bound) and a limit on the
  /// number of added points.
  std::string GetRefinementSwitches(double quality, double volume, int points) const;

  /// Returns the dimension of a cell type, or 0 if the type is unknown.
  static int GetDimension(int cellType);

  /// Runs TetGen and counts the call. Returns an error if there is no solution. A canceled run
  /// returns no error.
  Error Solve(const TetGenProblem& problem, TetGenSolution& solution);
};

}

#endif
