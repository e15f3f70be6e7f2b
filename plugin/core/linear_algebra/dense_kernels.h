#pragma once

namespace sherd {

// Dense matrices, column by column, `stride` numbers from one column to the next; only lower triangles of
// symmetric ones are read and written. By BLAS and LAPACK.

/// A = L L^T in place. False if A is not positive definite.
bool choleskyInPlace(double* a, int size, int stride);

/// B = B L^-T, with B of `rows` x `size`.
void divideByTransposed(const double* l, int size, int l_stride, double* b, int rows, int b_stride);

/// C = -A A^T, with A of `size` x `depth`.
void setToSquare(const double* a, int size, int depth, int a_stride, double* c, int c_stride);

/// C = -A B^T, with A of `rows` x `depth`, B of `columns` x `depth`.
void setToProduct(const double* a, int rows, const double* b, int columns, int depth, int stride, double* c,
                  int c_stride);

/// X = L^-1 X or L^-T X, with `count` columns in X, which lies row by row.
void solveLower(const double* l, int size, int stride, bool transposed, double* x, int count);

/// Y -= A X or A^T X, with A of `rows` x `columns` and `count` columns in X and Y, which lie row by row.
void subtractProduct(const double* a, int rows, int columns, int stride, bool transposed, const double* x,
                     int count, double* y);

/// C = A B, with A of `rows` x `depth`, B of `depth` x `columns`, all without gaps between columns.
void setToProduct(const double* a, int rows, const double* b, int columns, int depth, double* c);

/// Eigenvalues in ascending order, and orthonormal eigenvectors in the place of the matrix. False if the
/// iteration does not end.
bool symmetricEigenvectors(double* a, int size, double* values);

// The same in single precision, for small systems.

bool choleskyInPlace(float* a, int size, int stride);
/// x = L^-1 x or L^-T x.
void solveLower(const float* l, int size, int stride, bool transposed, float* x);
/// C -= A^T A, with A of `depth` x `size` without gaps between columns.
void subtractSquare(const float* a, int size, int depth, float* c, int c_stride);

}  // namespace sherd
