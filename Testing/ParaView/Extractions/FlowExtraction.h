// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowExtraction_h
#define FlowExtraction_h

#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

class vtkAlgorithm;
class vtkFlowLIC;
class vtkFlowVolume;
class vtkImplicitFlowField;
class vtkInflowMapping;
class vtkStreamSurfaceParameters;
class vtkTerminationSurface;

/**
 * The flow filters as JSON describes them, with properties by the names that they have in ParaView:
 * `source_properties` of the analytic flow, `surfaces` and `meshes` (each a `kind`, the label of
 * its proxy, and its `properties`), `axis` (properties of a vortex axis, whose lines are tubes of
 * `TubeRadius`), `field`, `mapping`, `image` (the extent of a wavelet), `volume`, and of its stream
 * surfaces `texture` (parameters) and `lic`.
 */
vtkSmartPointer<vtkAlgorithm> MakeFlow(const nlohmann::json& extraction);
vtkSmartPointer<vtkTerminationSurface> MakeTerminationSurface(const nlohmann::json& surface);
/// The triangles of a surface.
vtkSmartPointer<vtkAlgorithm> MakeSurfaceMesh(const nlohmann::json& surface);
vtkSmartPointer<vtkAlgorithm> MakeVortexAxis(const nlohmann::json& extraction);
vtkSmartPointer<vtkImplicitFlowField> MakeFlowField(const nlohmann::json& extraction);
vtkSmartPointer<vtkInflowMapping> MakeInflowMapping(const nlohmann::json& extraction);
vtkSmartPointer<vtkFlowVolume> MakeFlowVolume(const nlohmann::json& extraction);
///@{
/// For a volume that is up to date.
vtkSmartPointer<vtkStreamSurfaceParameters> MakeStreamSurfaceParameters(
  const nlohmann::json& extraction, vtkFlowVolume* volume);
vtkSmartPointer<vtkFlowLIC> MakeFlowLIC(const nlohmann::json& extraction, vtkFlowVolume* volume);
///@}

#endif
