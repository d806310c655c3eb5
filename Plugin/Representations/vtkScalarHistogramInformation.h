// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkScalarHistogramInformation_h
#define vtkScalarHistogramInformation_h

#include "InterlumeRepresentationsModule.h" // for the export macro
#include "vtkPVInformation.h"

#include <memory> // for the histogram
#include <string> // for the array

class vtkDataSet;

namespace interlume
{
struct ValueHistogram;
}

/**
 * @class   vtkScalarHistogramInformation
 * @brief   gathers the histogram of an array from all processes
 *
 * Pass it to GatherInformation of a source proxy. In each process and dataset, a large array is
 * divided into about a million parts of equal size, and one tuple at a varying position represents
 * each part in the histogram.
 */
class INTERLUMEREPRESENTATIONS_EXPORT vtkScalarHistogramInformation : public vtkPVInformation
{
public:
  static vtkScalarHistogramInformation* New();
  vtkTypeMacro(vtkScalarHistogramInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Set the output port of the source, the association and name of the array, the component (-1:
   * the magnitude), and an empty histogram with the bins to use.
   */
  void Initialize(int port, int association, const std::string& array, int component,
    const interlume::ValueHistogram& histogram);

  const interlume::ValueHistogram& GetHistogram() const { return *this->Histogram; }

  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* other) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  void CopyParametersToStream(vtkMultiProcessStream& stream) override;
  void CopyParametersFromStream(vtkMultiProcessStream& stream) override;

protected:
  vtkScalarHistogramInformation();
  ~vtkScalarHistogramInformation() override;

private:
  vtkScalarHistogramInformation(const vtkScalarHistogramInformation&) = delete;
  void operator=(const vtkScalarHistogramInformation&) = delete;

  void AddDataSet(vtkDataSet* data);

  int Port = 0;
  int Association = 0;
  std::string Array;
  int Component = 0;
  std::unique_ptr<interlume::ValueHistogram> Histogram;
};

#endif
