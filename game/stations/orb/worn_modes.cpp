#include "game/stations/orb/worn_modes.h"

#include <algorithm>

#include "core/assert.h"
#include "game/components/station.h"
#include "game/stations/orb/orb.h"
#include "haptics/modes.h"

namespace thaum::game::inline stations {
namespace {

/// Input of a mode's filters: the flow about the orb's middle. Its `spacing` is the step of the finite
/// differences that some filters use.
field::FilterSource source_of(const field::VortexFlow& flow, double radius) {
    constexpr int samples = 64;
    return {.field = haptics::any_field(field::field_of<field::Vector>(flow)),
            .count = {samples, samples, samples},
            .spacing = vec3(2 * radius / samples),
            .version = 1};
}

/// The flow's placement in the device frame of a hand.
field::Placement placement_in(const HandFrame& frame, const Orb& orb) {
    return {.origin = frame.to_device(orb.middle),
            .turn = glm::mat3_cast(glm::conjugate(frame.turn)),
            .scale = 1 / frame.metres_per_metre};
}

/// Adds the haptic primitives (simple forces) by which one mode of the orb is felt.
void add_mode(const OrbMode& mode, const field::TransferFunction& strength, const field::FilterSource& source,
              const field::Placement& placement, const haptics::ModeInput& input,
              haptics::PrimitiveSet& set) {
    const auto* kind = haptics::find_mode(mode.name);
    field::FilteredField filtered;
    const auto set_up = field::set_filters(filtered, source, mode.filters);
    THAUM_ASSERT(set_up && kind != nullptr, "the filters and the mode were checked when the file was read");
    field::PlacedField placed;
    field::place(placed, haptics::field_for(*kind, filtered), placement);
    const haptics::ModeUse use{
        .mode = kind, .field = placed.field, .settings = {.strength = strength, .friction = mode.friction}};
    haptics::add_modes(std::span(&use, 1), input, set);
}

}  // namespace

bool wears(const WornModes& modes, std::uint32_t mode) {
    return std::ranges::find(modes.worn, mode) != modes.worn.end();
}

bool put_on_or_off(WornModes& modes, std::uint32_t mode) {
    auto& worn = modes.worn;
    ++modes.version;
    if (const auto at = std::ranges::find(worn, mode); at != worn.end()) {
        std::copy(at + 1, worn.end(), at);
        worn.back() = no_mode;
        return false;
    }
    auto place = std::ranges::find(worn, no_mode);
    if (place == worn.end()) {
        std::copy(worn.begin() + 1, worn.end(), worn.begin());
        --place;
    }
    *place = mode;
    return true;
}

std::uint32_t last_worn(const WornModes& modes) {
    const auto end = std::ranges::find(modes.worn, no_mode);
    return end == modes.worn.begin() ? no_mode : *(end - 1);
}

std::uint32_t neighbour_of_last(const WornModes& modes, std::size_t count, int step) {
    const auto all = static_cast<std::uint32_t>(count);
    const auto last = last_worn(modes);
    std::uint32_t mode = last != no_mode ? last : step > 0 ? all - 1 : 0;
    for (std::uint32_t i = 0; i < all; ++i) {
        mode = (mode + (step > 0 ? 1 : all - 1)) % all;
        if (!wears(modes, mode)) return mode;
    }
    return no_mode;
}

vec2 on_sheet(const OrbRules& rules, const OrbMode& mode, vec3 hand, vec3 reach) {
    const auto share = [](double place, double half) { return std::clamp((place / half + 1) / 2, 0.0, 1.0); };
    return {mode.max_property * share(hand.x, reach.x),
            mode.least + (rules.most - mode.least) * share(hand.y, reach.y)};
}

void draw_curve(const OrbRules& rules, const OrbMode& mode, vec2 from, vec2 to,
                field::TransferFunction& strength) {
    field::draw_stroke(strength, from, to, mode.max_property * rules.column_share);
}

void refit_modes(const OrbRules& before, const OrbRules& current, WornModes& modes) {
    const auto worn = modes.worn;
    const auto strength = modes.strength;
    const bool same = std::ranges::equal(before.modes, current.modes, {}, &OrbMode::name, &OrbMode::name);
    if (!same) modes.worn.fill(no_mode);
    for (std::size_t i = 0; i < current.modes.size(); ++i)
        if (!same || modes.strength[i] == before.modes[i].strength)
            modes.strength[i] = current.modes[i].strength;
    if (modes.worn != worn || modes.strength != strength) ++modes.version;
}

void feel_orb(const MatchContext& context, ecs::Entity wizard, const HandState& hand_state,
              haptics::HapticModel& model) {
    const auto& world = context.world;
    const auto& rules = *context.data.orb;
    const auto& modes = world.get<WornModes>(wizard);
    model.primitives.clear();
    model.set_number = modes.version + 1;
    if (world.get<Scrying>(wizard).drawing != 0) return;
    const auto& orb = world.single<Orb>();
    const auto flow = flow_of(orb);
    const auto source = source_of(flow, orb.radius);
    const auto placement = placement_in(probe_frame(rules, orb, world.get<AtStation>(wizard).yaw), orb);
    const vec3 tip = haptics::measured_position(context.input.haptic_setup.device, hand_state.device);
    const auto& servo = hand_state.servo;
    model.coupling = {.stiffness = std::min(rules.stiffness, context.data.device.max_stiffness)};
    const haptics::ModeInput input{.proxy = servo.primitives == 0 ? tip : servo.proxy,
                                   .tip = tip,
                                   .stiffness = model.coupling.stiffness};
    for (const auto mode : modes.worn) {
        // Edited data files may have fewer modes.
        if (mode >= rules.modes.size()) continue;
        add_mode(rules.modes[mode], modes.strength[mode], source, placement, input, model.primitives);
    }
}

}  // namespace thaum::game::inline stations
