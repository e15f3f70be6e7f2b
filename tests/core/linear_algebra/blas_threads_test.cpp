#include <gtest/gtest.h>

#include <cstdlib>

#include "core/linear_algebra/dense_kernels.h"

extern "C" int openblas_get_num_threads() __attribute__((weak));

namespace {

// Its threads spin where others need the cores, and their number would change the bits.
TEST(DenseKernels, OpenBlasHasOneThreadUnlessTheUserChose) {
    if (!openblas_get_num_threads) GTEST_SKIP() << "another BLAS";
    if (std::getenv("OPENBLAS_NUM_THREADS") || std::getenv("OMP_NUM_THREADS")) GTEST_SKIP() << "chosen";
    double one = 4;
    ASSERT_TRUE(sherd::choleskyInPlace(&one, 1, 1));
    EXPECT_EQ(openblas_get_num_threads(), 1);
}

}  // namespace
