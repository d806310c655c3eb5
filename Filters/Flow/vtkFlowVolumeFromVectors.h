// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkFlowVolumeFromVectors_h
#define vtkFlowVolumeFromVectors_h

#include "InterlumeFlowModule.h" // for the export macro
#include "vtkInterlumeReport.h"  // for GetReport()
#include "vtkNew.h"              // for the filters
#include "vtkSmartPointer.h"     // for the input
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

class vtkCallbackCommand;
class vtkFlowVolume;
class vtkImplicitFlowField;
class vtkInflowMapping;
class vtkTerminationInflow;
class vtkTerminationSurface;

/**
 * @class   vtkFlowVolumeFromVectors
 * @brief   extract bands of a flow from vectors, in one step
 *
 * Chains vtkImplicitFlowField, vtkInflowMapping and vtkFlowVolume with settings that suit a first
 * image of any field. The flow that comes from a termination surface is divided into parallel bands
 * along the surface's parameter u. Every second band, each as wide as the gaps between them, is
 * extracted as tetrahedra: band i of n contains u from (i + 1/4)/n to (i + 3/4)/n.
 *
 * Input: as for vtkImplicitFlowField. The vectors are an array with three components:
 * SetInputArrayToProcess(0, ...), by default the active vectors.
 *
 * Output: tetrahedra with the arrays of port 0 of vtkFlowVolume. Inflow, the active scalars, is u.
 * The cell array IntervalId is the number of the band. If only NumberOfBands changes, streamlines
 * are not traced again. The output is identical for any number of threads. With several processes,
 * each process holds the whole field.
 *
 * Errors and warnings: as for the three filters.
 *
 * @sa vtkImplicitFlowField vtkInflowMapping vtkFlowVolume
 */
class INTERLUMEFLOW_EXPORT vtkFlowVolumeFromVectors : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkFlowVolumeFromVectors* New();
  vtkTypeMacro(vtkFlowVolumeFromVectors, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Surface on which streamlines end. Default: null, which selects a vtkTerminationInflow, a
   * rectangle where the flow enters the field.
   */
  void SetTerminationSurface(vtkTerminationSurface* surface);
  vtkTerminationSurface* GetTerminationSurface() const;
  ///@}

  ///@{
  /**
   * Number of bands. Default: 5. Valid: 1 to 1000; clamped.
   */
  void SetNumberOfBands(int number);
  vtkGetMacro(NumberOfBands, int);
  ///@}

  enum Resolutions
  {
    /// At most 32768 samples; cells at the boundary of the flow are skipped.
    PREVIEW = 0,
    /// The samples of PREVIEW; cells are cut at the boundary of the flow, as by
    /// vtkImplicitFlowField::CUT_BOUNDARY.
    AUTOMATIC = 1,
    /// All points of the field, with the same cuts.
    FULL = 2
  };
  ///@{
  /**
   * Number of samples. Default: AUTOMATIC. Valid: see Resolutions; clamped.
   */
  void SetResolution(int resolution);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Direction in which streamlines are followed, see vtkImplicitFlowField::Directions, and their
   * maximum time, where 0 means no limit. Default: BACKWARD (0), 0. Valid: 0 and 1; 0 and above;
   * clamped.
   */
  void SetDirection(int direction);
  int GetDirection() const;
  void SetMaximumTime(double time);
  double GetMaximumTime() const;
  ///@}

  /// Return the modification time of the filter and its surface.
  vtkMTimeType GetMTime() override;

  /// Return the values of the reports of vtkImplicitFlowField and vtkFlowVolume for the last
  /// execution.
  vtkInterlumeReport* GetReport() { return this->Report; }

  /// Return the summaries of vtkImplicitFlowField and vtkFlowVolume. The text is valid until the
  /// next call.
  const char* GetSummary();

protected:
  vtkFlowVolumeFromVectors();
  ~vtkFlowVolumeFromVectors() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkFlowVolumeFromVectors(const vtkFlowVolumeFromVectors&) = delete;
  void operator=(const vtkFlowVolumeFromVectors&) = delete;

  /// Passes a copy of the input and the selected array to the first filter if they have changed.
  void SetInnerInput(vtkDataObject* input);
  /// Forwards messages and progress of an inner filter, and aborts to it.
  void Forward(vtkObject* caller, unsigned long event, void* data);

  int NumberOfBands = 5;
  int Resolution = AUTOMATIC;
  vtkNew<vtkImplicitFlowField> Field;
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;
  vtkNew<vtkTerminationInflow> Inflow;
  vtkNew<vtkCallbackCommand> Forwarding;
  vtkSmartPointer<vtkDataObject> Input;
  vtkMTimeType InputTime = 0;
  vtkMTimeType ArrayTime = 0;
  /// True after an error message of the current execution.
  bool HasError = false;
  vtkNew<vtkInterlumeReport> Report;
  std::string Summary;
};

#endif
