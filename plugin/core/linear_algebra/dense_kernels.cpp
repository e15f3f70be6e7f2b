#include "core/linear_algebra/dense_kernels.h"

#include <cstddef>
#include <cstdlib>
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
void spotrf_(const char* uplo, const int* n, float* a, const int* lda, int* info);
void strsm_(const char* side, const char* uplo, const char* transa, const char* diag, const int* m,
            const int* n, const float* alpha, const float* a, const int* lda, float* b, const int* ldb);
void ssyrk_(const char* uplo, const char* trans, const int* n, const int* k, const float* alpha,
            const float* a, const int* lda, const float* beta, float* c, const int* ldc);
void sgemm_(const char* transa, const char* transb, const int* m, const int* n, const int* k,
            const float* alpha, const float* a, const int* lda, const float* b, const int* ldb,
            const float* beta, float* c, const int* ldc);
void strsv_(const char* uplo, const char* trans, const char* diag, const int* n, const float* a,
            const int* lda, float* x, const int* incx);
void sgemv_(const char* trans, const int* m, const int* n, const float* alpha, const float* a, const int* lda,
            const float* x, const int* incx, const float* beta, float* y, const int* incy);
void dsyevd_(const char* jobz, const char* uplo, const int* n, double* a, const int* lda, double* w,
             double* work, const int* lwork, int* iwork, const int* liwork, int* info);
#ifdef __GNUC__
void openblas_set_num_threads(int count) __attribute__((weak));  // OpenBLAS alone has it
#endif
}

namespace sherd {
namespace {

template <class Number>
struct Blas;

template <>
struct Blas<double> {
    static constexpr auto potrf = dpotrf_;
    static constexpr auto trsm = dtrsm_;
    static constexpr auto syrk = dsyrk_;
    static constexpr auto gemm = dgemm_;
    static constexpr auto trsv = dtrsv_;
    static constexpr auto gemv = dgemv_;
};

template <>
struct Blas<float> {
    static constexpr auto potrf = spotrf_;
    static constexpr auto trsm = strsm_;
    static constexpr auto syrk = ssyrk_;
    static constexpr auto gemm = sgemm_;
    static constexpr auto trsv = strsv_;
    static constexpr auto gemv = sgemv_;
};

template <class Number>
constexpr Number zero = 0;
template <class Number>
constexpr Number one = 1;
template <class Number>
constexpr Number minus_one = -1;
constexpr int step = 1;

// Work is shared out between threads above these kernels. OpenBLAS's own threads wait by spinning, which on
// cores that others use as well takes many times as long, and their number changes the bits.
bool limitBlasThreads() {
#ifdef __GNUC__
    const bool is_chosen = std::getenv("OPENBLAS_NUM_THREADS") || std::getenv("OMP_NUM_THREADS");
    if (!is_chosen && openblas_set_num_threads) openblas_set_num_threads(1);
    return !is_chosen;
#else
    return false;
#endif
}
[[maybe_unused]] const bool has_one_thread = limitBlasThreads();

}  // namespace

template <class Number>
bool choleskyInPlace(Number* a, int size, int stride) {
    int info = 0;
    Blas<Number>::potrf("L", &size, a, &stride, &info);
    return info == 0;
}

template <class Number>
void divideByTransposed(const Number* l, int size, int l_stride, Number* b, int rows, int b_stride) {
    Blas<Number>::trsm("R", "L", "T", "N", &rows, &size, &one<Number>, l, &l_stride, b, &b_stride);
}

template <class Number>
void setToSquare(const Number* a, int size, int depth, int a_stride, Number* c, int c_stride) {
    Blas<Number>::syrk("L", "N", &size, &depth, &minus_one<Number>, a, &a_stride, &zero<Number>, c,
                       &c_stride);
}

template <class Number>
void setToProduct(const Number* a, int rows, const Number* b, int columns, int depth, int stride, Number* c,
                  int c_stride) {
    Blas<Number>::gemm("N", "T", &rows, &columns, &depth, &minus_one<Number>, a, &stride, b, &stride,
                       &zero<Number>, c, &c_stride);
}

template <class Number>
void solveLower(const Number* l, int size, int stride, bool transposed, Number* x, int count) {
    if (count == 1)
        Blas<Number>::trsv("L", transposed ? "T" : "N", "N", &size, l, &stride, x, &step);
    else  // X^T = X^T L^-T or X^T L^-1
        Blas<Number>::trsm("R", "L", transposed ? "N" : "T", "N", &count, &size, &one<Number>, l, &stride, x,
                           &count);
}

template <class Number>
void subtractProduct(const Number* a, int rows, int columns, int stride, bool transposed, const Number* x,
                     int count, Number* y) {
    if (count == 1)
        Blas<Number>::gemv(transposed ? "T" : "N", &rows, &columns, &minus_one<Number>, a, &stride, x, &step,
                           &one<Number>, y, &step);
    else  // Y^T -= X^T A^T or X^T A
        Blas<Number>::gemm("N", transposed ? "N" : "T", &count, transposed ? &columns : &rows,
                           transposed ? &rows : &columns, &minus_one<Number>, x, &count, a, &stride,
                           &one<Number>, y, &count);
}

void setToProduct(const double* a, int rows, const double* b, int columns, int depth, double* c) {
    dgemm_("N", "N", &rows, &columns, &depth, &one<double>, a, &rows, b, &depth, &zero<double>, c, &rows);
}

bool symmetricEigenvectors(double* a, int size, double* values) {
    int info = 0;
    std::vector<double> work(1 + 6 * std::size_t(size) + 2 * std::size_t(size) * size);
    std::vector<int> numbers(3 + 5 * std::size_t(size));
    const int work_size = static_cast<int>(work.size()), number_count = static_cast<int>(numbers.size());
    dsyevd_("V", "L", &size, a, &size, values, work.data(), &work_size, numbers.data(), &number_count, &info);
    return info == 0;
}

template bool choleskyInPlace(float*, int, int);
template void divideByTransposed(const float*, int, int, float*, int, int);
template void setToSquare(const float*, int, int, int, float*, int);
template void setToProduct(const float*, int, const float*, int, int, int, float*, int);
template void solveLower(const float*, int, int, bool, float*, int);
template void subtractProduct(const float*, int, int, int, bool, const float*, int, float*);
template bool choleskyInPlace(double*, int, int);
template void divideByTransposed(const double*, int, int, double*, int, int);
template void setToSquare(const double*, int, int, int, double*, int);
template void setToProduct(const double*, int, const double*, int, int, int, double*, int);
template void solveLower(const double*, int, int, bool, double*, int);
template void subtractProduct(const double*, int, int, int, bool, const double*, int, double*);

}  // namespace sherd
