#ifndef vtkImageFlowWalker_h
#define vtkImageFlowWalker_h

#include "vtkImageFlowField.h"
#include "vtkLatticeFlowWalker.h"
#include "vtkRectilinearFlowField.h"

/// The walkers of images and of rectilinear grids.
using vtkImageFlowWalker = vtkLatticeFlowWalker<vtkImageFlowField>;
using vtkRectilinearFlowWalker = vtkLatticeFlowWalker<vtkRectilinearFlowField>;

#endif
