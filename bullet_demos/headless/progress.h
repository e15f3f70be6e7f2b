#pragma once

#include <string>

namespace demo {

/// Says on the standard error stream how far a run is. Whether that is a terminal only the caller knows.
class Progress {
  public:
    enum class Style {
        one_line,   ///< one line that is written over again and again: for terminals
        few_lines,  ///< a line each quarter: for logs
    };
    explicit Progress(Style style) : style_(style) {}

    /// `part` of the whole from 0 to 1, and what to say beside it.
    void show(double part, const std::string& what);

  private:
    Style style_;
    int shown_ = -1;  ///< hundredths or quarters that were shown last
};

}  // namespace demo
