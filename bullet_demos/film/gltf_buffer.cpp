#include "film/gltf_buffer.h"

#include <algorithm>

namespace demo {
namespace {

using nlohmann::ordered_json;

// Numbers that glTF 2.0 takes over from OpenGL.
constexpr int float_type = 5126, unsigned_int_type = 5125;
constexpr int no_target = 0, array_buffer = 34962, element_array_buffer = 34963;

/// A list of floats with the least and the largest value of each component.
ordered_json floatAccessor(const std::vector<float>& values, int width) {
    std::vector<float> low(values.begin(), values.begin() + width), high = low;
    for (std::size_t i = 0; i < values.size(); ++i) {
        low[i % width] = std::min(low[i % width], values[i]);
        high[i % width] = std::max(high[i % width], values[i]);
    }
    const char* type = width == 1 ? "SCALAR" : width == 3 ? "VEC3" : "VEC4";
    return {{"componentType", float_type},
            {"count", values.size() / width},
            {"type", type},
            {"min", low},
            {"max", high}};
}

}  // namespace

int GltfBuffer::addFloats(const std::vector<float>& values, int width) {
    return add(values.data(), values.size() * sizeof(float), floatAccessor(values, width), no_target);
}

int GltfBuffer::addVertices(const std::vector<float>& values, int width) {
    return add(values.data(), values.size() * sizeof(float), floatAccessor(values, width), array_buffer);
}

int GltfBuffer::addIndices(const std::vector<std::uint32_t>& indices) {
    return add(indices.data(), indices.size() * sizeof(std::uint32_t),
               {{"componentType", unsigned_int_type}, {"count", indices.size()}, {"type", "SCALAR"}},
               element_array_buffer);
}

int GltfBuffer::add(const void* data, std::size_t size, ordered_json accessor, int target) {
    ordered_json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}};
    if (target != no_target) view["target"] = target;
    // All that is added has four bytes a number, so that every offset is a multiple of four, as it has to be.
    bytes_.append(static_cast<const char*>(data), size);
    accessor["bufferView"] = views_.size();
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
}

}  // namespace demo
