#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace sherd {

/// What is wrong, where, and what to do about it, as one sentence a user can act on.
struct Error {
    std::string message;
};

/// A value, or the sentence that says why there is none.
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : state_(std::move(value)) {}
    Result(Error error) : state_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(state_); }
    explicit operator bool() const { return ok(); }

    /// The value; calling this on a failed result is a bug of the caller. It asserts, and without asserts
    /// throws std::bad_variant_access.
    T& value() & {
        assert(ok());
        return std::get<T>(state_);
    }
    const T& value() const& {
        assert(ok());
        return std::get<T>(state_);
    }
    T&& value() && {
        assert(ok());
        return std::get<T>(std::move(state_));
    }

    /// The sentence; empty when there is a value.
    std::string error() const { return ok() ? std::string() : std::get<Error>(state_).message; }

  private:
    std::variant<T, Error> state_;
};

/// Success, or the sentence that says why not.
using Status = Result<std::monostate>;
inline Status success() {
    return std::monostate{};
}

}  // namespace sherd
