// Four haptic primitives (simple sources of force), one of each kind, act on a proxy that a spring ties to
// the probe. Prints where the proxy comes to rest and with which force each primitive holds it there (device
// frame).
#include <array>
#include <iostream>

#include "core/hash.h"
#include "core/text.h"
#include "haptics/primitives/balance.h"

namespace {

using namespace thaum;
using haptics::PrimitiveKind;

std::string printed(vec3 v) { return text("(", v.x, ", ", v.y, ", ", v.z, ")"); }

/// A weight, an attracting point, an attracting line and a plane that pushes up what is below it.
constexpr std::array<haptics::Primitive, 4> primitives{{
    {.kind = PrimitiveKind::directed, .direction = {0, -1, 0}, .strength = 0.5},
    {.kind = PrimitiveKind::point, .position = {0.01, 0, 0}, .strength = 0.4},
    {.kind = PrimitiveKind::line, .position = {0, 0, 0.01}, .direction = {1, 0, 0}, .strength = 0.3},
    {.kind = PrimitiveKind::plane, .position = {0, -0.005, 0}, .direction = {0, 1, 0}, .strength = 2},
}};
constexpr std::array<std::string_view, 4> names{"directed", "point", "line", "plane"};

}  // namespace

int main() {
    const auto set = haptics::checked(primitives);
    if (!set) {
        std::cerr << set.error().message << '\n';
        return 1;
    }
    const vec3 probe{0.002, -0.01, 0.004};  // position of the probe (m)
    const auto found = haptics::balance(*set, {.centre = probe, .stiffness = 300});

    std::cout << text("probe  ", printed(probe), " m\nproxy  ", printed(found.proxy), " m\n");
    for (std::size_t i = 0; i < names.size(); ++i)
        std::cout << text(names[i], "  ", printed(found.primitive[i]), " N\n");
    std::cout << text("on the hand  ", printed(found.force), " N, at most ", found.residual, " N wrong, ",
                      found.steps, " steps\nhash ", hex(hash_value(found.proxy)), "\n");
}
