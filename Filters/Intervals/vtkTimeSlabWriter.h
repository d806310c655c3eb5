// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkTimeSlabWriter_h
#define vtkTimeSlabWriter_h

#include "InterlumeIntervalsModule.h" // for the export macro
#include "vtkTimeVaryingIntervalVolume.h"

#include <map>    // for digests of steps
#include <string> // for file names
#include <vector> // for the output ports

namespace interlume
{
class Error;
class Fingerprint;
}

/**
 * @class   vtkTimeSlabWriter
 * @brief   write a time-varying interval volume slab by slab
 *
 * Writes the output of vtkTimeVaryingIntervalVolume for many time steps but holds only one slab
 * (the space-time region between two time steps) in memory. Set the input and the settings as for
 * that filter and call Write(). All slabs together contain the tetrahedra, boundaries and
 * 4-simplices of a single extraction of all steps, with the same values of `TimeSlab`. Points at a
 * step are stored in both adjacent slabs. If values at a step equal a bound, boundaries and
 * `AtStep` cells at that step are computed from each slab separately. Criteria may split the same
 * region into other simplices.
 *
 * Files, for FileName vortex.vtm: one file per slab in VTK's XML format, vortex/vortex_0.vtu,
 * vortex/vortex_1.vtu, ..., and the index vortex.vtm, a vtkMultiBlockDataSet whose blocks are named
 * by their times. Selected boundaries and 4-simplices are indexed by vortex_boundaries.vtm and
 * vortex_simplices.vtm.
 *
 * Resuming: an index exists only if all slabs are complete. Each slab is written to a temporary
 * file, which is then renamed. Write() reuses intact slab files whose field data records the same
 * digest of the input and the same settings, times and versions of Interlume and VTK. The steps are
 * still read to compute the digest, but not extracted. Other files are replaced, with one warning
 * that reports their number and the first difference.
 *
 * The default of SizeWarningLimit is 0 in this class, and PreviewCellLimit is ignored. The writer
 * runs in one process and requests the full input. Each interior time step is read twice. Progress
 * events refer to the current slab. An abort stops after the current slab and writes no index.
 *
 * Errors (vtkErrorMacro, Write() returns false): no FileName, no input, composite input, a file
 * that cannot be written, and the errors of vtkTimeVaryingIntervalVolume.
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
   * Set/get the name of the index file of the tetrahedra. The names of all other files are derived
   * from it. Default null, which is an error in Write().
   */
  void SetFileName(VTK_FILEPATH const char* name);
  VTK_FILEPATH const char* GetFileName() const;
  ///@}

  /// Extract and write all slabs. Returns true if all slabs are complete. Afterward, the output
  /// ports are empty.
  bool Write();

  ///@{
  /**
   * Return the number of slabs that the last Write() wrote, and of existing slabs that it reused.
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

  /// An output port that is written, and the stem of its file names.
  struct Port
  {
    int Number;
    std::string Stem;
  };
  std::vector<Port> GetPorts(const std::vector<bool>& kinds);
  /// Returns the path of a slab's file, relative to the index file if \a isInIndex is true.
  std::string GetSlabName(const Port& port, std::size_t slab, bool isInIndex) const;
  std::string GetIndexName(const Port& port) const;
  /// Extracts and writes the slabs that have no valid files yet.
  interlume::Error WriteSlabs(const std::vector<int>& steps, const std::vector<bool>& kinds);
  /// Sets the step range and the boundary kinds for a slab.
  void SetSlab(std::size_t slab, const std::vector<int>& steps, const std::vector<bool>& kinds);
  /// Returns a fingerprint of the settings that the files of a slab depend on. It excludes the
  /// input.
  interlume::Fingerprint MakeFingerprint(std::size_t slab, const double* times);
  void AddSteps(interlume::Fingerprint& fingerprint, const double* times) const;
  /// Returns whether valid files of a slab exist. If files exist but are not valid, \a difference
  /// describes the first difference.
  bool IsWritten(
    const std::vector<Port>& ports, std::size_t slab, const double* times, std::string& difference);
  interlume::Error WriteSlab(const std::vector<Port>& ports, std::size_t slab, const double* times);
  bool WriteIndex(const Port& port, const std::vector<double>& times) const;
  /// Stores the digest of a time step.
  void AddDigest(double time, vtkDataSet* step);
  /// Reads a time step and stores its digest, unless the digest is known.
  void FindDigest(double time);

  std::string FileName;
  int WrittenSlabs = 0;
  int ResumedSlabs = 0;
  /// Digests of the current time steps, by time.
  std::map<double, std::string> StepDigests;
};

#endif
