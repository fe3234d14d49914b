#include "input/arm.h"

#include <algorithm>
#include <cmath>

#include "core/letters.h"
#include "core/text.h"
#include "input/frame.h"

namespace thaum::input {
namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

}  // namespace

std::int32_t quantised(double value) {
    constexpr double most = 1e9;
    return static_cast<std::int32_t>(std::lround(std::clamp(value, -most, most)));
}

std::string name_of(const ArmFacts& facts) {
    return facts.serial.empty() ? facts.spec.name : text(facts.spec.name, " ", facts.serial);
}

std::array<std::uint32_t, 3> box_um(const ArmFacts& facts) {
    std::array<std::uint32_t, 3> um{};
    for (int axis = 0; axis < 3; ++axis) {
        const double edge = facts.spec.workspace[axis] * 1e6;
        if (!(edge >= 1 && edge <= DeviceSpec::max_box_um)) return {};
        um[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(std::lround(edge));
    }
    return um;
}

bool is_called(const ArmFacts& facts, std::string_view word) {
    const auto is = [&](std::string_view name) { return !name.empty() && same_word(name, word); };
    return is("arm") || is(facts.family) || is(facts.spec.name) || is(facts.serial) || is(name_of(facts));
}

std::string caption_of(const ArmStatus& status) {
    if (status.state == ArmPresence::present) return {};
    auto words = status.text.substr(0, status.text.find(';'));
    if (!words.empty()) words.front() = upper(words.front());
    return words;
}

vec3 rotation_vector(const mat3& rotation) {
    constexpr double no_turn = 1e-9;
    auto q = glm::quat_cast(rotation);
    if (q.w < 0) q = -q;
    const vec3 axis(q.x, q.y, q.z);
    const double sine = glm::length(axis);  // sine of half the angle
    return sine < no_turn ? 2.0 * axis : axis * (2 * det::atan2(sine, q.w) / sine);
}

}  // namespace thaum::input
