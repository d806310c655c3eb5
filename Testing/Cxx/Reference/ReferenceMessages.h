#ifndef ReferenceMessages_h
#define ReferenceMessages_h

#include <string> // for the messages

class vtkAlgorithm;

namespace reference
{

/// The errors of a filter and its executive while it is updated.
std::string MessagesOf(vtkAlgorithm* filter);

}

#endif
