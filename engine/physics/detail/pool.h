// physics/detail/pool.h: the pool from which Bullet gets its memory; its statistics are in memory.h.
#pragma once

namespace thaum::physics::detail {

/// Makes Bullet's allocator use the pool, once per process. Must run before the first Bullet object is
/// made.
void use_pool();

}  // namespace thaum::physics::detail
