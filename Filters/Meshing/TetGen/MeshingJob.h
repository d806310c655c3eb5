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
 * One execution of vtkTetrahedralMesher: its settings, its TetGen process, and its results. The
 * functions of Meshers fill Mesh or return an error. If a job is canceled, they return no error,
 * and Mesh must not be used.
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

  /// Sets the unit of length of the points passed to TetGen (see Tetrahedra::UnitExponent), and
  /// converts the volume bound to this unit.
  void SetUnit(int exponent);
  /// Returns whether a quality or volume bound is set.
  bool IsRefining() const { return this->QualityBound > 0.0 || this->MaximumVolume > 0.0; }
  /// Returns TetGen's switches for refinement with the given bounds (0 for no bound) and limit on
  /// the number of added points.
  std::string GetRefinementSwitches(double quality, double volume, int points) const;

  /// Returns the dimension of a cell type, or 0 if the type is unknown.
  static int GetDimension(int cellType);

  /// Runs TetGen and counts the call. Returns an error if there is no solution. A canceled run
  /// returns no error.
  Error Solve(const TetGenProblem& problem, TetGenSolution& solution);
};

}

#endif
