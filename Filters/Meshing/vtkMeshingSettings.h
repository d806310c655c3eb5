// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMeshingSettings_h
#define vtkMeshingSettings_h

#include <string> // for the worker's name

/**
 * @class   vtkMeshingSettings
 * @brief   settings of vtkTetrahedralMesher
 *
 * vtkTetrahedralMesher is derived from this struct so that VTK's set/get macros can access the
 * settings, and passes a copy of them to each MeshingJob. Its setters document the settings.
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
