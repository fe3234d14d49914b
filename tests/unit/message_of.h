// unit/message_of.h: the message of a result's error.
#pragma once
#include <string>
#include <string_view>

#include "core/error.h"

namespace thaum {

/// Message of the result's error. `none` stands for a result without an error.
template <class T>
std::string message_of(const Expected<T>& result, std::string_view none = "") {
    return result ? std::string(none) : result.error().message;
}

}  // namespace thaum
