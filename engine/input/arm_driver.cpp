#include "input/arm_driver.h"

#include "input/detail/arm_ticks.h"

namespace thaum::input {

Expected<bool> ArmDriver::start(std::uint64_t) { return false; }

bool run_arm_tick(std::uint64_t ticks) noexcept { return run_tick(ticks); }

}  // namespace thaum::input
