#include "core/threads.h"

#include <sched.h>

#include <algorithm>
#include <csignal>

namespace thaum {

void FaultStack::begin_use() noexcept {
    stack_t before{};
    if (::sigaltstack(nullptr, &before) != 0 || (before.ss_flags & SS_DISABLE) == 0) return;
    stack_t stack{};
    stack.ss_sp = memory_.data();
    stack.ss_size = memory_.size();
    used_ = ::sigaltstack(&stack, nullptr) == 0;
}

void FaultStack::end_use() noexcept {
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    if (used_) ::sigaltstack(&none, nullptr);
    used_ = false;
}

unsigned processors() noexcept {
    cpu_set_t allowed;
    if (::sched_getaffinity(0, sizeof allowed, &allowed) != 0) return 1;
    return static_cast<unsigned>(std::max(1, CPU_COUNT(&allowed)));
}

}  // namespace thaum
