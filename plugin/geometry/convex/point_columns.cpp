#include "geometry/convex/point_columns.h"

#include <algorithm>

#include "core/numerics/wide_vectors.h"

namespace sherd {

namespace {

constexpr long block = 64, lanes = 16;  // numbers looked at side by side

}  // namespace

SHERD_WIDE_VECTORS void findReach(const float* x, const float* y, const float* z, std::size_t count,
                                  const float* way, float* reach) {
    const float a = way[0], b = way[1], c = way[2];
    for (std::size_t p = 0; p < count; ++p) reach[p] = a * x[p] + (b * y[p] + c * z[p]);
}

SHERD_WIDE_VECTORS void findExtremes(const float* numbers, long count, float* highest, float* lowest) {
    float high[block], low[block];
    for (long i = 0; i < block; ++i) high[i] = low[i] = numbers[0];
    long first = 0;
    for (; first + block <= count; first += block)
        for (long i = 0; i < block; ++i) {
            const float number = numbers[first + i];
            high[i] = number > high[i] ? number : high[i];
            low[i] = number < low[i] ? number : low[i];
        }
    for (long other = lanes; other < block; other += lanes)
        for (long i = 0; i < lanes; ++i) {
            high[i] = high[i + other] > high[i] ? high[i + other] : high[i];
            low[i] = low[i + other] < low[i] ? low[i + other] : low[i];
        }
    *highest = *std::max_element(high, high + lanes);
    *lowest = *std::min_element(low, low + lanes);
    for (; first < count; ++first) {
        *highest = std::max(*highest, numbers[first]);
        *lowest = std::min(*lowest, numbers[first]);
    }
}

SHERD_WIDE_VECTORS int firstPlace(const float* numbers, long count, float wanted) {
    long first = 0;
    for (; first + block <= count; first += block) {
        int found = 0;
        for (long i = 0; i < block; ++i) found |= numbers[first + i] == wanted ? 1 : 0;
        if (found) break;
    }
    while (numbers[first] != wanted) ++first;
    return static_cast<int>(first);
}

SHERD_WIDE_VECTORS void giveWhereFurther(const float* x, const float* y, const float* z, std::size_t count,
                                         const float* normal, float height, int own, float* furthest,
                                         int* face) {
    const float a = normal[0], b = normal[1], c = normal[2];
    for (std::size_t p = 0; p < count; ++p) {
        const float distance = a * x[p] + (b * y[p] + (c * z[p] - height));
        const bool is_further = distance > furthest[p];
        furthest[p] = is_further ? distance : furthest[p];
        face[p] = is_further ? own : face[p];
    }
}

}  // namespace sherd
