// SPDX-License-Identifier: BSD-3-Clause
#ifndef PieceWriter_h
#define PieceWriter_h

#include <string>

class vtkUnstructuredGrid;

/**
 * Cuts a grid into \a count slabs of equally many cells along x and writes them as a .pvtu file and
 * its pieces, so that each of as many processes reads one. A piece has the point array \a array and
 * the global point ids of the grid, which the grid must have; its points are in the reverse order
 * of these ids, so that an extraction must go by them to agree with one of the whole. It also has,
 * marked as ghosts, the cells of the other pieces that share a point with its own.
 * @param path  the .pvtu file, without its extension.
 * @throw std::runtime_error when a file can't be written.
 */
void WritePieces(vtkUnstructuredGrid* grid, const char* array, int count, const std::string& path);

#endif
