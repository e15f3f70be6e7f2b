#pragma once

namespace sherd {

// Dense matrices, column by column, `stride` numbers from one column to the next; only lower triangles of
// symmetric ones are read and written. By BLAS and LAPACK, in single and double precision.

/// A = L L^T in place. False if A is not positive definite.
template <class Number>
bool choleskyInPlace(Number* a, int size, int stride);

/// B = B L^-T, with B of `rows` x `size`.
template <class Number>
void divideByTransposed(const Number* l, int size, int l_stride, Number* b, int rows, int b_stride);

/// C = -A A^T, with A of `size` x `depth`.
template <class Number>
void setToSquare(const Number* a, int size, int depth, int a_stride, Number* c, int c_stride);

/// C = -A B^T, with A of `rows` x `depth`, B of `columns` x `depth`.
template <class Number>
void setToProduct(const Number* a, int rows, const Number* b, int columns, int depth, int stride, Number* c,
                  int c_stride);

/// X = L^-1 X or L^-T X, with `count` columns in X, which lies row by row.
template <class Number>
void solveLower(const Number* l, int size, int stride, bool transposed, Number* x, int count = 1);

/// Y -= A X or A^T X, with A of `rows` x `columns` and `count` columns in X and Y, which lie row by row.
template <class Number>
void subtractProduct(const Number* a, int rows, int columns, int stride, bool transposed, const Number* x,
                     int count, Number* y);

/// C = A B, with A of `rows` x `depth`, B of `depth` x `columns`, all without gaps between columns.
void setToProduct(const double* a, int rows, const double* b, int columns, int depth, double* c);

/// Eigenvalues in ascending order, and orthonormal eigenvectors in the place of the matrix. False if the
/// iteration does not end.
bool symmetricEigenvectors(double* a, int size, double* values);

}  // namespace sherd
