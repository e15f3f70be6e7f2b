#include "headless/progress.h"

#include <algorithm>
#include <iostream>

namespace demo {

void Progress::show(double part, const std::string& what) {
    const int steps = style_ == Style::one_line ? 100 : 4;
    const int reached = std::min(steps, static_cast<int>(part * steps));
    if (reached == shown_) return;
    shown_ = reached;
    std::string line = std::to_string(reached * 100 / steps) + " %  " + what;
    line.insert(0, line.find(' ') < 3 ? 3 - line.find(' ') : 0, ' ');
    if (style_ == Style::few_lines) {
        std::cerr << line << "\n";
        return;
    }
    // Padded, so that a shorter line leaves nothing of a longer one behind.
    line.resize(std::max<std::size_t>(line.size(), 78), ' ');
    std::cerr << "\r" << line << (reached == steps ? "\n" : "") << std::flush;
}

}  // namespace demo
