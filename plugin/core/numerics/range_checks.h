#pragma once

#include <sherd/result.h>

#include <cmath>
#include <sstream>
#include <string>

namespace sherd {

/// Collects the first value of a struct that is out of its range, as one sentence. NaN is out of every range.
class RangeChecks {
  public:
    explicit RangeChecks(std::string subject) : subject_(std::move(subject)) {}

    /// `allowed` goes on from "must be": "positive", "between 0 and 1".
    template <class T>
    RangeChecks& require(bool condition, const char* member, T value, const char* allowed) {
        if (condition || !sentence_.empty()) return *this;
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << subject_ << ": " << member << " is " << value << " but must be " << allowed << ".";
        sentence_ = text.str();
        return *this;
    }

    Status status() const { return sentence_.empty() ? success() : Status(Error{sentence_}); }

  private:
    std::string subject_, sentence_;
};

inline bool isPositive(double value) {
    return std::isfinite(value) && value > 0;
}
inline bool isNotNegative(double value) {
    return std::isfinite(value) && value >= 0;
}
inline bool isWithin(double value, double low, double high) {
    return value >= low && value <= high;
}

}  // namespace sherd
