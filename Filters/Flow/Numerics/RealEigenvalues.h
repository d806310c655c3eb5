// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RealEigenvalues_h
#define interlume_RealEigenvalues_h

namespace interlume
{

/**
 * Eigenvalues of real 3x3 matrices, symmetric or not.
 */
namespace RealEigenvalues
{
/**
 * Computes the eigenvalues as (real part, imaginary part), sorted by descending real part. In a
 * conjugate pair, the eigenvalue with positive imaginary part is first. Eigen's QR algorithm is
 * applied to the balanced matrix. The error is a few times the rounding error of the matrix norm.
 * The results are NaN if the matrix is not finite.
 */
void Compute(const double matrix[9], double eigenvalues[6]);
}

}

#endif
