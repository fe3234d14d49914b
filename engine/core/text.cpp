#include "core/text.h"

#include "core/assert.h"
#include "core/one_line.h"

namespace thaum {

std::string fixed(double value, int digits) {
    THAUM_ASSERT(digits >= 0 && digits <= 60, "fixed: digits from 0 to 60");
    char buffer[400];  // the largest double has 309 digits before the point
    const auto end =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, digits).ptr;
    return {buffer, end};
}

std::string hex(unsigned long long value) {
    std::string out(16, '0');
    for (std::size_t i = 16; i-- > 0; value >>= 4) out[i] = "0123456789abcdef"[value & 15U];
    return out;
}

std::string in_one_line(std::string_view message) {
    constexpr std::size_t most = 1000;
    auto line = message.size() > most ? text(message.substr(0, most), "...") : std::string(message);
    for (auto& c : line) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    }
    return line;
}

}  // namespace thaum
