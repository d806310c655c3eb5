// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkPVImplicitFlowField_h
#define vtkPVImplicitFlowField_h

#include "InterlumeFlowProxiesModule.h" // for the export macro
#include "vtkImplicitFlowField.h"

class vtkPolyData;

/**
 * @class   vtkPVImplicitFlowField
 * @brief   an implicit flow field whose termination surfaces are inputs of a pipeline too
 *
 * Input port 2, optional and repeatable: vtkPolyData. Polygons and strips of a dataset are a
 * vtkTerminationMesh, with the dataset's texture coordinates as parameters; each line with two
 * points and more is a vtkTerminationTube. They come after the surfaces that are added, dataset by
 * dataset, lines after polygons. All of each is asked for, whatever the piece.
 *
 * Output port 1: vtkPolyData, the surfaces that the execution used as vtkTerminationSurfaceSource
 * draws them, with their ids; without the faces of the domain, and in the first piece alone.
 */
class INTERLUMEFLOWPROXIES_EXPORT vtkPVImplicitFlowField : public vtkImplicitFlowField
{
public:
  static vtkPVImplicitFlowField* New();
  vtkTypeMacro(vtkPVImplicitFlowField, vtkImplicitFlowField);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Disconnects port 2, and no other port.
  void RemoveAllSurfaceInputs();

  ///@{
  /**
   * The radius of the tubes around lines, in world units. Default 0.5. Valid: above 0.
   */
  vtkSetMacro(TubeRadius, double);
  vtkGetMacro(TubeRadius, double);
  ///@}

  ///@{
  /**
   * Whether u, or v, of the meshes goes around. Default off.
   */
  vtkSetMacro(MeshPeriodicU, bool);
  vtkGetMacro(MeshPeriodicU, bool);
  vtkBooleanMacro(MeshPeriodicU, bool);
  vtkSetMacro(MeshPeriodicV, bool);
  vtkGetMacro(MeshPeriodicV, bool);
  vtkBooleanMacro(MeshPeriodicV, bool);
  ///@}

protected:
  vtkPVImplicitFlowField();
  ~vtkPVImplicitFlowField() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPVImplicitFlowField(const vtkPVImplicitFlowField&) = delete;
  void operator=(const vtkPVImplicitFlowField&) = delete;

  using SurfaceList = std::vector<vtkSmartPointer<vtkTerminationSurface>>;
  /// Makes the surfaces of port 2.
  SurfaceList MakeSurfaces(vtkInformationVector* inputs) const;

  /// Appends the triangles of the surfaces.
  void DrawSurfaces(vtkPolyData* output) const;

  double TubeRadius = 0.5;
  bool MeshPeriodicU = false;
  bool MeshPeriodicV = false;
};

#endif
