#include <algorithm>
#include <cmath>

#include "game/components/orb.h"
#include "game/senses/sound/scene_parts.h"

namespace thaum::game::inline senses {
namespace {

/// Changes of a loose thing's speed in one frame (8 ms) from which on a blow is audible, and has full
/// loudness (m/s).
constexpr double heard_change = 1.2, loud_change = 8;
constexpr double usual_mass = 40;   ///< mass of a thing that gives the sound its recorded pitch (kg)
constexpr Tick between_blows = 96;  ///< minimum time between two sounds of a thing (ticks)

ThingSoundMemory& memory_of(SoundMemory& memory, ecs::Entity thing) {
    if (memory.things.size() <= thing.index) memory.things.resize(thing.index + 1);
    return memory.things[thing.index];
}

/// A blow makes the thing slower; a push or a throw makes it faster.
bool is_blow(vec3 before, vec3 after) { return glm::length(after) < glm::length(before); }

void add_thing(SoundWriting& writing, ecs::Entity e, const Motion& motion, const Look& look,
               const Body& body) {
    auto& memory = memory_of(writing.memory, e);
    const vec3 before = memory.velocity;
    const bool known = memory.known;
    memory.velocity = motion.velocity;
    memory.known = true;
    const double change = glm::length(motion.velocity - before);
    if (!known || change < heard_change || !is_blow(before, motion.velocity) ||
        writing.played() < memory.quiet_until)
        return;
    memory.quiet_until = writing.played() + between_blows;
    const double pitch = std::clamp(std::cbrt(usual_mass / std::max(body.mass, 1.0)), 0.6, 1.6);
    begin(writing, hit_on(material_of(look.surface)),
          {.place = motion.position, .gain = std::min(1.0, change / loud_change), .pitch = pitch});
}

/// Elapsed share of the time until the brew boils over, 0 to 1; 0 for a pure brew.
double ripeness(const SoundWriting& writing, const Cauldron& cauldron) {
    if (cauldron.begun == 0 || writing.played() <= cauldron.begun) return 0;
    const auto whole = std::max<Tick>(1, writing.match.data().cauldron->spoils_after);
    return std::min(1.0, seconds(writing.played() - cauldron.begun) / seconds(whole));
}

}  // namespace

void add_thing_sounds(SoundWriting& writing) {
    writing.match.world().view<const Prop, const Motion, const Look, const Body>().each(
        [&](ecs::Entity e, const Prop&, const Motion& motion, const Look& look, const Body& body) {
            add_thing(writing, e, motion, look, body);
        });
}

void add_brew_sounds(SoundWriting& writing) {
    if (!writing.match.data().cauldron) return;
    const auto& cauldron = writing.match.world().single<Cauldron>();
    const double ripe = ripeness(writing, cauldron);
    if (cauldron.begun == 0) return;
    last(writing, writing.sounds.cues.at(static_cast<std::size_t>(Cue::boil)), lasting::boil,
         {.place = cauldron.middle, .gain = 0.3 + 0.7 * ripe, .pitch = 0.8 + 0.5 * ripe});
}

void add_orb_sounds(SoundWriting& writing) {
    // Distance of the probe from the orb's hidden core, as a share of the orb's radius, from which on the hum
    // is lowest.
    constexpr double far_from_core = 0.6;
    const auto& world = writing.match.world();
    if (world.count<Orb>() == 0) return;
    const auto& orb = world.single<Orb>();
    world.view<const Wizard, const Scrying>().each([&](const Wizard& wizard, const Scrying& scrying) {
        const double near = std::clamp(1 - scrying.distance / (far_from_core * orb.radius), 0.0, 1.0);
        last(writing, writing.sounds.cues.at(static_cast<std::size_t>(Cue::orb_hum)),
             lasting::orb + wizard.player,
             {.place = scrying.place, .gain = 0.3 + 0.7 * near, .pitch = 1 + near * near});
    });
}

}  // namespace thaum::game::inline senses
