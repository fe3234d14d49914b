// core/assert.h: wrong use of our own code. On in every build, since a wrong handle in a match must stop there
// and not ten minutes later; so the condition must be cheap.
#pragma once
#include <string_view>

namespace thaum {

/// Prints "file:line: message" to standard error and aborts.
[[noreturn]] void assertion_failed(const char* file, int line, std::string_view message);

}  // namespace thaum

/// THAUM_ASSERT(condition, message): message is evaluated only on failure; core/text.h's text() builds it.
#define THAUM_ASSERT(condition, message)                            \
    do {                                                            \
        if (!(condition)) [[unlikely]] {                            \
            ::thaum::assertion_failed(__FILE__, __LINE__, message); \
        }                                                           \
    } while (false)
