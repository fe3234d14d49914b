// physics/detail/pool.h: the pool behind physics/memory.h.
#pragma once

namespace thaum::physics::detail {

/// Points Bullet's allocator at the pool, once per process; must run before the first Bullet object is made.
void use_pool();

}  // namespace thaum::physics::detail
