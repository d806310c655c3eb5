// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RealEigenvalues_h
#define interlume_RealEigenvalues_h

namespace interlume
{

/**
 * Eigenvalues of real matrices of three rows and columns, symmetric or not.
 */
namespace RealEigenvalues
{
/**
 * Three complex numbers, real part first, by descending real part; of a pair the one with the
 * positive imaginary part first. By Eigen's QR method on the balanced matrix: the error is a few
 * roundings of the matrix's norm. NaN for a matrix that is not finite.
 */
void Compute(const double matrix[9], double eigenvalues[6]);
}

}

#endif
