// physics/bullet_build.h: the version of Bullet that this program is built with. The header of a log contains
// it, because another version would compute slightly different motions.
#pragma once
#include <string>

namespace thaum::physics {

/// Version and precision of Bullet.
struct BulletBuild {
    std::string library;    ///< name and version, such as "Bullet 3.24"
    std::string precision;  ///< precision of Bullet's numbers, "double" or "single"
};

/// Version and precision of the linked library.
BulletBuild bullet_build();

}  // namespace thaum::physics
