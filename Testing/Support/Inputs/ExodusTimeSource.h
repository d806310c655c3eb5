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
 * A temporal source of one unstructured grid: the first block of an Exodus file, with all point
 * arrays. It announces the time steps of the file and returns the block at the requested time, or
 * at the first time step if none is requested.
 *
 * vtkExodusIIReader itself returns a multiblock dataset, so filters would return multiblock
 * datasets too.
 */
class ExodusTimeSource : public vtkUnstructuredGridAlgorithm
{
public:
  static ExodusTimeSource* New();
  vtkTypeMacro(ExodusTimeSource, vtkUnstructuredGridAlgorithm);

  /**
   * Sets the path of the file. If the file has no block, the update reports an error.
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
