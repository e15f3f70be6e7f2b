#include "geometry/sentences.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace sherd {

std::string firstOf(const std::vector<int>& numbers) {
    constexpr std::size_t most = 5;
    std::string text;
    const std::size_t count = std::min(most, numbers.size());
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_last = i + 1 == count && count == numbers.size();
        if (i > 0) text += is_last ? " and " : ", ";
        text += std::to_string(numbers[i]);
    }
    return count < numbers.size() ? text + " ..." : text;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string threeDigits(double value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(3);
    text << value;
    return text.str();
}

}  // namespace sherd
