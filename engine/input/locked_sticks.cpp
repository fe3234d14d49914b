#include "input/locked_sticks.h"

#include <fcntl.h>
#include <linux/input.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "core/file.h"

namespace thaum::input {
namespace {

constexpr std::size_t max_file = 4096;
constexpr unsigned bits_in_word = 64;

/// First line of a file in /sys; empty if there is none.
std::string first_line(const std::filesystem::path& path) {
    auto words = read_text_file(path, max_file).value_or(std::string());
    words.resize(std::min(words.size(), words.find('\n')));
    return words;
}

/// Tests a bit of a bit set that Linux writes as hexadecimal words, the highest word first.
bool has_bit(std::string_view words, unsigned bit) {
    for (; bit >= bits_in_word && !words.empty(); bit -= bits_in_word)
        words =
            words.substr(0, words.find_last_of(' ') == std::string_view::npos ? 0 : words.find_last_of(' '));
    const auto word = words.substr(words.find_last_of(' ') + 1);
    std::uint64_t value = 0;
    std::from_chars(word.data(), word.data() + word.size(), value, 16);
    return bit < bits_in_word && (value >> bit & 1U) != 0;
}

/// Whether a device is a joystick or a gamepad: it has the first button of either.
bool is_stick(const std::filesystem::path& device) {
    const auto keys = first_line(device / "capabilities" / "key");
    return has_bit(keys, BTN_JOYSTICK) || has_bit(keys, BTN_GAMEPAD);
}

bool is_locked(const std::filesystem::path& path) {
    const int fd = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return errno == EACCES || errno == EPERM;
    ::close(fd);
    return false;
}

}  // namespace

std::vector<LockedStick> locked_sticks(const std::filesystem::path& system,
                                       const std::filesystem::path& devices) {
    std::vector<LockedStick> locked;
    std::error_code error;
    for (std::filesystem::directory_iterator it(system, error), end; !error && it != end;
         it.increment(error)) {
        const auto name = it->path().filename();
        const auto path = devices / name;
        if (!name.string().starts_with("event") || !is_stick(it->path() / "device") || !is_locked(path))
            continue;
        locked.push_back({first_line(it->path() / "device" / "name"), path.string()});
    }
    std::sort(locked.begin(), locked.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return locked;
}

}  // namespace thaum::input
