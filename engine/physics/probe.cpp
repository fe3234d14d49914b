#include "physics/probe.h"

#include <cmath>

#include "core/hash.h"

namespace thaum::physics {
namespace {

// volatile: the compiler would otherwise compute the answers itself, correctly rounded, and ask no library.
double opaque(double x) {
    volatile double hidden = x;
    return hidden;
}

std::uint64_t mix(std::uint64_t hash, double value) { return hash_value(value, hash); }

std::uint64_t probe_at(std::uint64_t hash, double unit) {
    const double x = opaque(unit);               // in (0, 1)
    const double wide = opaque(unit * 50 - 25);  // several turns
    hash = mix(hash, std::sin(wide));
    hash = mix(hash, std::cos(wide));
    hash = mix(hash, std::tan(wide));
    hash = mix(hash, std::atan2(wide, x));
    hash = mix(hash, std::acos(opaque(2 * unit - 1)));
    hash = mix(hash, std::asin(opaque(2 * unit - 1)));
    hash = mix(hash, std::pow(x, opaque(0.001 + unit)));
    hash = mix(hash, std::exp(wide));
    return mix(hash, std::log(x));
}

}  // namespace

std::uint64_t libm_probe() {
    constexpr int arguments = 512;
    std::uint64_t hash = 0;
    for (int i = 0; i < arguments; ++i) hash = probe_at(hash, (i + 0.37) / arguments);
    return hash;
}

}  // namespace thaum::physics
