#include "input/arm_driver.h"

#include <algorithm>

#include "input/detail/arm_ticks.h"

namespace thaum::input {
namespace {

std::vector<ArmDriverKind>& kinds() {
    static std::vector<ArmDriverKind> all;
    return all;
}

}  // namespace

Expected<bool> ArmDriver::start(std::uint64_t) { return false; }

bool run_arm_tick(std::uint64_t ticks) noexcept { return run_tick(ticks); }

ArmDriverRegistration::ArmDriverRegistration(const ArmDriverKind& kind) {
    auto& all = kinds();
    // Registrations come in an order that the linker chooses, so the list is kept sorted.
    const auto after =
        std::find_if(all.begin(), all.end(), [&](const auto& k) { return kind.name < k.name; });
    all.insert(after, kind);
}

const std::vector<ArmDriverKind>& arm_drivers() { return kinds(); }

}  // namespace thaum::input
