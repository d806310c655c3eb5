// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMeshingSettings_h
#define vtkMeshingSettings_h

#include <string> // for the worker's name

/**
 * @class   vtkMeshingSettings
 * @brief   settings of vtkTetrahedralMesher
 *
 * vtkTetrahedralMesher inherits the settings so that VTK's set/get macros apply, and passes them to
 * each MeshingJob. The setters of the filter document them.
 *
 * @sa vtkTetrahedralMesher
 */
struct vtkMeshingSettings
{
  double QualityBound = 0.0;
  double MinimumDihedralAngle = 0.0;
  double MaximumVolume = 0.0;
  int MaximumNumberOfAddedPoints = 2000000;
  bool PreserveBoundary = false;
  bool FillNestedShells = false;
  bool SplitContacts = true;
  double TimeLimit = 600.0;
  std::string WorkerFileName;
};

#endif
