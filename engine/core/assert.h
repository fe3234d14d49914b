// core/assert.h: assertions against wrong use of our own code.
//
// Assertions are on in every build: a wrong handle must stop the match at once, not ten minutes later. Every
// condition must therefore be cheap.
#pragma once
#include <string_view>

namespace thaum {

/// Prints "file:line: message" to standard error and aborts.
[[noreturn]] void assertion_failed(const char* file, int line, std::string_view message);

}  // namespace thaum

/// Prints the message and aborts if the condition is false. The message is evaluated only then; `text()`
/// (core/text.h) builds one.
#define THAUM_ASSERT(condition, message)                            \
    do {                                                            \
        if (!(condition)) [[unlikely]] {                            \
            ::thaum::assertion_failed(__FILE__, __LINE__, message); \
        }                                                           \
    } while (false)
