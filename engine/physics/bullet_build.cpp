#include "physics/bullet_build.h"

#include <LinearMath/btScalar.h>

#include "core/text.h"

namespace thaum::physics {

BulletBuild bullet_build() {
    constexpr int version = BT_BULLET_VERSION;
    const auto* precision = sizeof(btScalar) == sizeof(double) ? "double" : "single";
    return {text("Bullet ", version / 100, '.', version % 100), precision};
}

}  // namespace thaum::physics
