#include "core/linear_algebra/dense_kernels.h"

#include <cstddef>
#include <vector>

extern "C" {
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dtrsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const double* alpha, const double* a, const int* lda, double* b, const int* ldb);
void dsyrk_(const char* uplo, const char* trans, const int* n, const int* k, const double* alpha,
            const double* a, const int* lda, const double* beta, double* c, const int* ldc);
void dgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
            const double* beta, double* c, const int* ldc);
void dtrsv_(const char* uplo, const char* trans, const char* diag, const int* n, const double* a,
            const int* lda, double* x, const int* incx);
void dgemv_(const char* trans, const int* m, const int* n, const double* alpha, const double* a,
            const int* lda, const double* x, const int* incx, const double* beta, double* y, const int* incy);
void dsyevd_(const char* jobz, const char* uplo, const int* n, double* a, const int* lda, double* w,
             double* work, const int* lwork, int* iwork, const int* liwork, int* info);
void spotrf_(const char* uplo, const int* n, float* a, const int* lda, int* info);
void strsv_(const char* uplo, const char* trans, const char* diag, const int* n, const float* a,
            const int* lda, float* x, const int* incx);
void ssyrk_(const char* uplo, const char* trans, const int* n, const int* k, const float* alpha,
            const float* a, const int* lda, const float* beta, float* c, const int* ldc);
}

namespace sherd {
namespace {

constexpr double zero = 0, one = 1, minus_one = -1;
constexpr int step = 1;

}  // namespace

bool choleskyInPlace(double* a, int size, int stride) {
    int info = 0;
    dpotrf_("L", &size, a, &stride, &info);
    return info == 0;
}

void divideByTransposed(const double* l, int size, int l_stride, double* b, int rows, int b_stride) {
    dtrsm_("R", "L", "T", "N", &rows, &size, &one, l, &l_stride, b, &b_stride);
}

void setToSquare(const double* a, int size, int depth, int a_stride, double* c, int c_stride) {
    dsyrk_("L", "N", &size, &depth, &minus_one, a, &a_stride, &zero, c, &c_stride);
}

void setToProduct(const double* a, int rows, const double* b, int columns, int depth, int stride, double* c,
                  int c_stride) {
    dgemm_("N", "T", &rows, &columns, &depth, &minus_one, a, &stride, b, &stride, &zero, c, &c_stride);
}

void solveLower(const double* l, int size, int stride, bool transposed, double* x, int count) {
    if (count == 1)
        dtrsv_("L", transposed ? "T" : "N", "N", &size, l, &stride, x, &step);
    else  // X^T = X^T L^-T or X^T L^-1
        dtrsm_("R", "L", transposed ? "N" : "T", "N", &count, &size, &one, l, &stride, x, &count);
}

void subtractProduct(const double* a, int rows, int columns, int stride, bool transposed, const double* x,
                     int count, double* y) {
    if (count == 1)
        dgemv_(transposed ? "T" : "N", &rows, &columns, &minus_one, a, &stride, x, &step, &one, y, &step);
    else  // Y^T -= X^T A^T or X^T A
        dgemm_("N", transposed ? "N" : "T", &count, transposed ? &columns : &rows,
               transposed ? &rows : &columns, &minus_one, x, &count, a, &stride, &one, y, &count);
}

void setToProduct(const double* a, int rows, const double* b, int columns, int depth, double* c) {
    dgemm_("N", "N", &rows, &columns, &depth, &one, a, &rows, b, &depth, &zero, c, &rows);
}

bool symmetricEigenvectors(double* a, int size, double* values) {
    int info = 0;
    std::vector<double> work(1 + 6 * std::size_t(size) + 2 * std::size_t(size) * size);
    std::vector<int> numbers(3 + 5 * std::size_t(size));
    const int work_size = static_cast<int>(work.size()), number_count = static_cast<int>(numbers.size());
    dsyevd_("V", "L", &size, a, &size, values, work.data(), &work_size, numbers.data(), &number_count, &info);
    return info == 0;
}

bool choleskyInPlace(float* a, int size, int stride) {
    int info = 0;
    spotrf_("L", &size, a, &stride, &info);
    return info == 0;
}

void solveLower(const float* l, int size, int stride, bool transposed, float* x) {
    strsv_("L", transposed ? "T" : "N", "N", &size, l, &stride, x, &step);
}

void subtractSquare(const float* a, int size, int depth, float* c, int c_stride) {
    constexpr float plus = 1, minus = -1;
    ssyrk_("L", "T", &size, &depth, &minus, a, &depth, &plus, c, &c_stride);
}

}  // namespace sherd
