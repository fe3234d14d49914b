// Tests of device files: the shipped files are read, and the message about each fault names it.
#include "haptics/device.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "core/file.h"
#include "unit/message_of.h"

namespace thaum::haptics {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(THAUM_SOURCE_DIR) / "assets/devices";

std::string shipped(const std::string& name) {
    auto content = read_text_file(folder / (name + ".toml"), 1U << 16U);
    EXPECT_TRUE(content.has_value()) << (content ? "" : content.error().message);
    return content ? *content : "";
}

Expected<DeviceSpec> read(const std::string& toml) {
    const auto config = Config::parse(toml, "touch.toml", 1);
    if (!config) return config.error();
    return read_device(*config);
}

/// Error of touch.toml after replacing the line that starts with `key`.
std::string fault_of(const std::string& key, const std::string& line) {
    auto toml = shipped("touch");
    const auto at = toml.find("\n" + key) + 1;
    toml.replace(at, toml.find('\n', at) - at, line);
    return message_of(read(toml));
}

TEST(HapticsDevice, TheFiveModelsAreRead) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const auto config =
            Config::parse(*read_text_file(entry.path(), 1U << 16U), entry.path().filename(), 1).value();
        const auto spec = read_device(config);
        ASSERT_TRUE(spec.has_value()) << spec.error().message;
        ++count;
    }
    EXPECT_EQ(count, 5);
    const auto spec = *read(shipped("touch"));
    EXPECT_EQ(spec.name, "Touch");
    EXPECT_EQ(spec.peak_force, 3.3);
    EXPECT_EQ(spec.max_stiffness, 400);
    EXPECT_EQ(spec.sensed, 6);
    EXPECT_EQ(spec.actuated, 3);
    EXPECT_EQ(read(shipped("omega3"))->max_stiffness, 5000);
    EXPECT_EQ(read(shipped("falcon"))->latency, 1);
    EXPECT_EQ(read(shipped("premium"))->actuated, 6);
    EXPECT_EQ(read(shipped("omni"))->max_damping, 5);
}

TEST(HapticsDevice, EveryNumberOfTheModelsHasItsSource) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::istringstream lines(*read_text_file(entry.path(), 1U << 16U));
        for (std::string line; std::getline(lines, line);) {
            if (line.find('=') == std::string::npos || line[0] == '#' || line.starts_with("version") ||
                line.starts_with("name"))
                continue;
            const auto comment = line.substr(std::min(line.find('#'), line.size()));
            EXPECT_TRUE(comment.find("assumed") != std::string::npos ||
                        comment.find('[') != std::string::npos)
                << entry.path().filename() << ": " << line;
        }
    }
}

TEST(HapticsDevice, FaultsNameFileAndKey) {
    struct Case {
        std::string key, line, message;
    };
    for (const auto& [key, line, message] : {
             Case{"mass_kg", "mass_kg = -0.1", "mass_kg"},
             Case{"mass_kg", "mass_kg = 0", "mass_kg"},
             Case{"mass_kg", "mass_kg = nan", "mass_kg"},
             Case{"mass_kg", "mass_kg = \"light\"", "mass_kg"},
             Case{"mass_kg", "mas_kg = 0.1", "mass_kg"},
             Case{"peak_n", "peak_n = 3.3\npeek_n = 2", "unknown key 'force.peek_n'"},
             Case{"continuous_n", "continuous_n = 4", "'continuous_n'"},
             Case{"sensed", "sensed = 2", "'sensed'"},
             Case{"sensed", "sensed = 0", "'sensed'"},
             Case{"actuated", "actuated = 7", "'actuated'"},
             Case{"latency_ticks", "latency_ticks = 9", "latency_ticks"},
             Case{"latency_ticks", "latency_ticks = 0.5", "latency_ticks"},
             Case{"position_quantum_m", "position_quantum_m = 0.009", "position_quantum_m"},
             Case{"workspace_m", "workspace_m = [0.16, 0, 0.07]", "workspace_m"},
             Case{"coulomb_friction_n", "coulomb_friction_n = 5", "'coulomb_friction_n'"},
             Case{"update_rate_hz", "update_rate_hz = 1e9", "update_rate_hz"},
             Case{"name", "name = \"\"", "name"},
             Case{"version", "version = 2", "version"},
         }) {
        const auto fault = fault_of(key, line);
        EXPECT_TRUE(fault.starts_with("touch.toml")) << line << ": " << fault;
        EXPECT_NE(fault.find(message), std::string::npos) << line << ": " << fault;
        EXPECT_EQ(fault.find('\n'), std::string::npos);
    }
}

}  // namespace
}  // namespace thaum::haptics
