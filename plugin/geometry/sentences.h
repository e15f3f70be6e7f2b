#pragma once

#include <string>
#include <vector>

namespace sherd {

/// "3", "3 and 7", or "3, 7, 9 ..." with the first five of a list of numbers.
std::string firstOf(const std::vector<int>& numbers);

/// "1 hole" or "3 holes".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// "0.0125": three digits.
std::string threeDigits(double value);

}  // namespace sherd
