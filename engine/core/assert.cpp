#include "core/assert.h"

#include <cstdio>
#include <cstdlib>

namespace thaum {

void assertion_failed(const char* file, int line, std::string_view message) {
    std::fprintf(stderr, "%s:%d: %.*s\n", file, line, static_cast<int>(message.size()), message.data());
    std::abort();
}

}  // namespace thaum
