// tests/unit/shipped_devices.h: all haptic devices of the product.
#pragma once
#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/file.h"
#include "haptics/device.h"

namespace thaum::haptics {

/// Device specs in assets/devices, sorted by file name.
inline std::vector<DeviceSpec> shipped_devices() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(THAUM_SOURCE_DIR "/assets/devices"))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<DeviceSpec> result;
    for (const auto& file : files) {
        const auto toml = read_text_file(file, 1U << 16U);
        result.push_back(*read_device(*Config::parse(*toml, file.filename(), 1)));
    }
    return result;
}

}  // namespace thaum::haptics
