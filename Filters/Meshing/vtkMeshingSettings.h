// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkMeshingSettings_h
#define vtkMeshingSettings_h

#include <string> // for the worker's name

/**
 * @class   vtkMeshingSettings
 * @brief   what vtkTetrahedralMesher can be told of the mesh, with its defaults
 *
 * The filter is made of them, so that VTK's macros for setters serve them, and hands them on as a
 * whole. Each is documented at its setter there.
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
