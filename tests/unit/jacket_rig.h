// Helpers for tests of jackets: byte traces, and frames of a jacket's layout.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>

#include "core/file.h"
#include "tactile/frame.h"

namespace thaum::input::rig {

/// Time after which a test gives up waiting for something that must come (ms).
inline constexpr int patience_ms = 60'000;

/// Bytes of a trace in tests/tactile: two hexadecimal digits for each byte; lines with # are comments.
inline std::string trace(const std::string& name) {
    const auto file =
        read_text_file(std::filesystem::path(THAUM_SOURCE_DIR) / "tests/tactile" / name, 1U << 16U).value();
    std::istringstream lines(file);
    std::string bytes;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream words(line);
        for (std::string byte; words >> byte;) bytes += static_cast<char>(std::stoi(byte, nullptr, 16));
    }
    return bytes;
}

/// A frame for a jacket. The listed actuators have amplitudes, all others are off.
inline tactile::TactileFrame jacket_frame(std::size_t count,
                                          std::initializer_list<std::pair<std::size_t, float>> on,
                                          Tick time_to_live = 100) {
    tactile::TactileFrame frame{.time_to_live = time_to_live, .count = count};
    for (const auto& [actuator, amplitude] : on) {
        frame.amplitude.at(actuator) = amplitude;
        frame.carrier_hz.at(actuator) = 100;
    }
    return frame;
}

}  // namespace thaum::input::rig
