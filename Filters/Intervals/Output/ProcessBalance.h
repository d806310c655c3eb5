// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ProcessBalance_h
#define interlume_ProcessBalance_h

class vtkAlgorithm;

namespace interlume
{

struct ExtractionReport;

/**
 * @class   ProcessBalance
 * @brief   gathers the extraction load of all processes
 */
class ProcessBalance
{
public:
  /**
   * Gathers the number of cells with output in each process into the report, and adds the counts
   * and the load balance to the field data of the filter's first output. This call is collective if
   * each process requested its own piece from the filter. Otherwise it does nothing.
   */
  static void Gather(vtkAlgorithm* filter, ExtractionReport& report);
};

}

#endif
