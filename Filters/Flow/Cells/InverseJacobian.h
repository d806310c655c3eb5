#ifndef interlume_InverseJacobian_h
#define interlume_InverseJacobian_h

namespace interlume
{

/**
 * @class   InverseJacobian
 * @brief   the inverse of the Jacobian dx/dp of a cell
 *
 * \a columns[j] is dx/dp_j; of the result, row i is dp_i/dx. Where columns are dependent, as on a
 * collapsed edge, no such inverse exists: then the coordinates that the others can do without get
 * rows of 0, so that p stays along them, and the other rows are those of the least squares.
 */
class InverseJacobian
{
public:
  static void Invert(const double columns[3][4], double inverse[3][3])
  {
    const double* a = columns[0];
    const double* b = columns[1];
    const double* c = columns[2];
    Cross(b, c, inverse[0]);
    Cross(c, a, inverse[1]);
    Cross(a, b, inverse[2]);
    const double determinant = Dot(a, inverse[0]);
    // By the lengths of the columns: cells may be flat and small as long as they are not sheared
    // into a plane.
    const double scale = Dot(a, a) * Dot(b, b) * Dot(c, c);
    if (!(determinant * determinant > 1e-18 * scale && scale < 1e300))
    {
      InvertSingular(columns, inverse);
      return;
    }
    const double factor = 1.0 / determinant;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        inverse[i][j] *= factor;
      }
    }
  }

  static void Multiply(const double rows[3][3], const double vector[3], double product[3])
  {
    const double v[3] = { vector[0], vector[1], vector[2] };
    for (int i = 0; i < 3; ++i)
    {
      product[i] = Dot(rows[i], v);
    }
  }

  /// sum_j d[j] columns[j].
  static void Combine(const double columns[3][4], const double d[3], double sum[3])
  {
    const double factor[3] = { d[0], d[1], d[2] };
    for (int i = 0; i < 3; ++i)
    {
      sum[i] = factor[0] * columns[0][i] + factor[1] * columns[1][i] + factor[2] * columns[2][i];
    }
  }

private:
  static double Dot(const double* a, const double* b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static void Cross(const double* a, const double* b, double* product)
  {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
  }

  static void InvertSingular(const double columns[3][4], double inverse[3][3]);
};

}

#endif
