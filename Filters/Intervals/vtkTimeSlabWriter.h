// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeSlabWriter_h
#define vtkTimeSlabWriter_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkTimeVaryingIntervalVolume.h"

#include <map>    // for digests of steps
#include <string> // for names
#include <vector> // for several of them

namespace interlume
{
class Error;
class Fingerprint;
}

/**
 * @class   vtkTimeSlabWriter
 * @brief   writes the interval volume of many time steps slab by slab, in the memory of one slab
 *
 * A vtkTimeVaryingIntervalVolume, with its input and settings, that holds two time steps and what
 * lies between them at a time. Write extracts one slab after the other and writes each to a file of
 * its own; all slabs together are the tetrahedra, boundaries and 4-simplices of the extraction of
 * all steps, with the same numbers in TimeSlab. Points at a step are there in the slabs before and
 * after it. Where values equal bounds at a step, each slab has what it has there by itself, in
 * boundaries and in the cells AtStep.
 *
 * Files, for FileName vortex.vtm: vortex/vortex_0.vtu, vortex/vortex_1.vtu, ..., a slab each, in
 * VTK's XML format, and the index vortex.vtm, a vtkMultiBlockDataSet that has them for blocks,
 * named by their times. Boundaries, where any are asked for, and 4-simplices come likewise in
 * vortex_boundaries.vtm and vortex_simplices.vtm.
 *
 * **Stopped, and resumed.** The indices are removed first and written last, so that there is one if
 * and only if all slabs are there. A slab is written beside its file and renamed, so that files of
 * slabs are whole. Write takes over those that are there if they are whole and of the same input,
 * settings, times and versions of Interlume and VTK: their field data has a digest of both time
 * steps, with all point arrays. For that the steps are read, but nothing is extracted. Others are
 * written anew, with one warning that says how many, and what differs in the first.
 *
 * One process writes: the whole input is asked for. Each time step is read twice, for the slabs
 * before and after it. Progress is that of each slab; its text names the step. An abort ends after
 * the slab at hand, without an index.
 *
 * Errors (vtkErrorMacro, Write returns false): no FileName, no input, composite input, a file that
 * cannot be written, and those of vtkTimeVaryingIntervalVolume.
 *
 * @sa vtkTimeVaryingIntervalVolume
 */
class INTERLUMEINTERVALS_EXPORT vtkTimeSlabWriter : public vtkTimeVaryingIntervalVolume
{
public:
  static vtkTimeSlabWriter* New();
  vtkTypeMacro(vtkTimeSlabWriter, vtkTimeVaryingIntervalVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The name of the index of the tetrahedra, by which the others are named too. Default null, an
   * error.
   */
  void SetFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetFileName() const;
  ///@}

  /// Extracts and writes all slabs. Returns whether all are there. The outputs are empty then.
  bool Write();

  ///@{
  /**
   * Return how many slabs the last Write has made, and how many it found there.
   */
  int GetNumberOfWrittenSlabs() const { return this->WrittenSlabs; }
  int GetNumberOfResumedSlabs() const { return this->ResumedSlabs; }
  ///@}

protected:
  vtkTimeSlabWriter();
  ~vtkTimeSlabWriter() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTimeSlabWriter(const vtkTimeSlabWriter&) = delete;
  void operator=(const vtkTimeSlabWriter&) = delete;

  /// An output that is written, and the first part of its files' names.
  struct Port
  {
    int Number;
    std::string Stem;
  };
  std::vector<Port> GetPorts(const std::vector<bool>& kinds);
  /// Returns the name of the file of a slab, in the folder of the index or as the index has it.
  std::string GetSlabName(const Port& port, std::size_t slab, bool isInIndex) const;
  std::string GetIndexName(const Port& port) const;
  /// Extracts and writes the slabs, but for those that are there.
  interlume::Error WriteSlabs(const std::vector<double>& times, const std::vector<bool>& kinds);
  /// Sets the step range and the kinds of boundaries for a slab.
  void SetSlab(std::size_t slab, std::size_t last, int firstStep, const std::vector<bool>& kinds);
  /// Returns what the files of a slab depend on, but for the input.
  interlume::Fingerprint MakeFingerprint(std::size_t slab, const double* times);
  void AddSteps(interlume::Fingerprint& fingerprint, const double* times) const;
  /// Returns whether the files of a slab are there and this one's; \a different says what differs,
  /// where they are there and are not.
  bool IsWritten(
    const std::vector<Port>& ports, std::size_t slab, const double* times, std::string& different);
  interlume::Error WriteSlab(const std::vector<Port>& ports, std::size_t slab, const double* times);
  bool WriteIndex(const Port& port, const std::vector<double>& times) const;
  /// Reads a time step for its digest, if that is not known.
  void FindDigest(double time);

  std::string FileName;
  int WrittenSlabs = 0;
  int ResumedSlabs = 0;
  /// The digests of the time steps of the slab at hand.
  std::map<double, std::string> StepDigests;
};

#endif
