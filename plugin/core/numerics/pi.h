#pragma once

namespace sherd {

constexpr double pi = 3.14159265358979323846;

}  // namespace sherd
