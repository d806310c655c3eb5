// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExodusTimeSource_h
#define ExodusTimeSource_h

#include "vtkNew.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <string>

class vtkExodusIIReader;

namespace interlume
{
/**
 * Source that returns the first block of an Exodus file, with all point arrays. The block must be
 * an unstructured grid. Provides the time steps of the file. If no time is requested, returns the
 * first time step.
 *
 * With vtkExodusIIReader, which returns a multiblock dataset, filters would return multiblock
 * datasets too.
 */
class ExodusTimeSource : public vtkUnstructuredGridAlgorithm
{
public:
  static ExodusTimeSource* New();
  vtkTypeMacro(ExodusTimeSource, vtkUnstructuredGridAlgorithm);

  /**
   * Sets the path of the file. Update() reports an error if the first block is not an unstructured
   * grid.
   */
  void SetFileName(const std::string& path);

protected:
  ExodusTimeSource();
  ~ExodusTimeSource() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  ExodusTimeSource(const ExodusTimeSource&) = delete;
  void operator=(const ExodusTimeSource&) = delete;

  vtkNew<vtkExodusIIReader> Reader;
};
}

#endif
