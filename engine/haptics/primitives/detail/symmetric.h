// haptics/primitives/detail/symmetric.h: symmetric 3 by 3 matrices, composed of identities and dyads.
#pragma once
#include <algorithm>

#include "core/maths.h"

namespace thaum::haptics::balancing {

struct Symmetric {
    double xx{}, xy{}, xz{}, yy{}, yz{}, zz{};
};

inline Symmetric scaled_identity(double a) { return {a, 0, 0, a, 0, a}; }

/// M += a u u^T
inline void add_dyad(Symmetric& m, double a, vec3 u) {
    const vec3 v = a * u;
    m.xx += v.x * u.x, m.xy += v.x * u.y, m.xz += v.x * u.z;
    m.yy += v.y * u.y, m.yz += v.y * u.z, m.zz += v.z * u.z;
}

/// M += a (u v^T + v u^T)
inline void add_pair(Symmetric& m, double a, vec3 u, vec3 v) {
    const vec3 w = a * v;
    m.xx += 2 * w.x * u.x, m.xy += w.x * u.y + w.y * u.x, m.xz += w.x * u.z + w.z * u.x;
    m.yy += 2 * w.y * u.y, m.yz += w.y * u.z + w.z * u.y, m.zz += 2 * w.z * u.z;
}

inline void add_identity(Symmetric& m, double a) { m.xx += a, m.yy += a, m.zz += a; }

inline vec3 times(const Symmetric& m, vec3 v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
}

/// Solves M x = b by L D L^T. A pivot (element of D) below `least` is taken for a rounding error and replaced
/// by `least`.
inline vec3 solve(const Symmetric m, vec3 b, double least) {
    const double d0 = 1 / std::max(m.xx, least);
    const double l10 = m.xy * d0, l20 = m.xz * d0;
    const double d1 = 1 / std::max(m.yy - l10 * m.xy, least);
    const double u21 = m.yz - l20 * m.xy;
    const double l21 = u21 * d1;
    const double d2 = 1 / std::max(m.zz - l20 * m.xz - l21 * u21, least);
    const double y1 = b.y - l10 * b.x;
    const double y2 = b.z - l20 * b.x - l21 * y1;
    const double x2 = y2 * d2;
    const double x1 = y1 * d1 - l21 * x2;
    return {b.x * d0 - l10 * x1 - l20 * x2, x1, x2};
}

}  // namespace thaum::haptics::balancing
