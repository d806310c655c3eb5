#ifndef ReferenceThreads_h
#define ReferenceThreads_h

#include "ReferenceCheck.h" // for the result

#include "vtkSmartPointer.h" // for the outputs

#include <functional> // for what is run
#include <string>     // for its name
#include <vector>     // for the outputs

class vtkUnstructuredGrid;

namespace reference
{

/// The outputs of \a run are the same bytes for 1, 2 and 8 threads and every backend, and none is
/// empty.
void CheckThreads(const std::string& name,
  const std::function<std::vector<vtkSmartPointer<vtkUnstructuredGrid>>()>& run, Check& check);

}

#endif
