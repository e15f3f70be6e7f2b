#pragma once

#include <sherd/result.h>

#include <cmath>
#include <locale>
#include <sstream>
#include <string>

namespace sherd {

/// Collects the first value of a struct that is out of its range, as one sentence. NaN is out of every range.
class RangeChecks {
  public:
    explicit RangeChecks(std::string subject) : subject_(std::move(subject)) {}

    /// `allowed` goes on from "must be": "positive", "between 0 and 1".
    template <class T>
    RangeChecks& require(bool condition, const std::string& member, const T& value,
                         const std::string& allowed) {
        if (condition || !fault_.empty()) return *this;
        std::ostringstream text;
        text.imbue(std::locale::classic());
        text << member << " is " << value << " but must be " << allowed;
        fault_ = text.str();
        return *this;
    }

    /// The sentence without its subject and full stop; empty if nothing is out of range.
    const std::string& fault() const { return fault_; }

    Status status() const {
        return fault_.empty() ? success() : Status(Error{subject_ + ": " + fault_ + "."});
    }

  private:
    std::string subject_, fault_;
};

inline bool isPositive(double value) {
    return std::isfinite(value) && value > 0;
}

}  // namespace sherd
