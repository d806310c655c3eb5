// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ProcessBalance_h
#define interlume_ProcessBalance_h

class vtkAlgorithm;

namespace interlume
{

struct ExtractionReport;

/**
 * @class   ProcessBalance
 * @brief   what the processes of an extraction in pieces tell each other of their work
 */
class ProcessBalance
{
public:
  /**
   * Puts the cells with output of all processes into the report, and both that and the balance into
   * the field data of the filter's first output. Collective where the filter was asked for the
   * piece of this process among as many pieces as there are processes; else nothing is done.
   */
  static void Gather(vtkAlgorithm* filter, ExtractionReport& report);
};

}

#endif
