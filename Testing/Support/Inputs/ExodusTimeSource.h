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
 * A temporal source of one unstructured grid: an Exodus file with one block. Announces the file's
 * time steps and gives the block at the one asked for, with all its point arrays; without a time,
 * at the first.
 *
 * vtkExodusIIReader itself gives a multiblock dataset, for which filters give another one.
 */
class ExodusTimeSource : public vtkUnstructuredGridAlgorithm
{
public:
  static ExodusTimeSource* New();
  vtkTypeMacro(ExodusTimeSource, vtkUnstructuredGridAlgorithm);

  /**
   * The file's path. A file without a block is an error when the pipeline runs.
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
