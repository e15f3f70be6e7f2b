#pragma once

#include <string>

namespace sherd {

/// Ends a message with another sentence, which it says once.
inline void addSentence(std::string& message, const std::string& sentence) {
    if (message.find(sentence) == std::string::npos) message += (message.empty() ? "" : " ") + sentence;
}

}  // namespace sherd
