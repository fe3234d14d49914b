#include "core/text.h"

namespace thaum {

std::string fixed(double value, int digits) {
    char buffer[400];
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr;
    return {buffer, end};
}

std::string hex(unsigned long long value) {
    std::string out(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) out[i] = "0123456789abcdef"[value & 15U];
    return out;
}

}  // namespace thaum
