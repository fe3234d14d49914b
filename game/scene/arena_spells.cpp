// Strokes and spells in the world: the trail of a stroke, the shell of a shield, fog, and the dust of a push.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "game/data/spell.h"
#include "game/data/teams.h"
#include "game/picture/stroke_pieces.h"
#include "game/scene/arena_parts.h"

namespace thaum::game::inline scene {

using render::colour;
using render::Instance;

namespace {

// ---- Strokes ----------------------------------------------------------------------------------------------

/// Size of a stroke in the world relative to the hand's motion. A circle of 8 cm is 40 cm wide.
constexpr double stroke_scale = 5;
/// Maximum number of pieces of a stroke in the world.
constexpr std::size_t max_pieces = 40;

/// Light of a stroke (linear): the team's colour during the stroke, then green if it was recognised, else
/// grey.
fvec3 light_of(const StrokePicture& stroke, std::uint32_t team) {
    const auto left = static_cast<float>(1 - stroke.since_end_s / stroke_fade_seconds);
    if (stroke.drawing) return 1.4F * team_colours(team).light;
    return std::clamp(left, 0.0F, 1.0F) * (stroke.read ? colour(0x5CFF80) : colour(0x807C88));
}

/// Whether a piece is left out, because the stroke was not recognised and breaks up.
bool is_gone(const StrokePicture& stroke, std::uint32_t piece) {
    if (stroke.drawing || stroke.read) return false;
    return piece % 5 < 1 + static_cast<std::uint32_t>(3 * stroke.since_end_s / stroke_fade_seconds);
}

/// Adds the pieces of a stroke. `place` gives the position of a point by its number (m, world).
template <class Place>
void add_pieces(const ArenaScene& arena_scene, const StrokePicture& stroke, std::uint32_t team, double thick,
                Place place, std::vector<Instance>& out) {
    const auto light = light_of(stroke, team);
    std::uint32_t piece = 0;
    each_piece(stroke.count, max_pieces, place, [&](std::size_t from, std::size_t to) {
        if (is_gone(stroke, piece++)) return;
        const double wide = thick * (1 + 0.5 * std::min(2.0, static_cast<double>(stroke.points[to].force)));
        add_beam(arena_scene, place(from), place(to), wide, light, out);
    });
}

}  // namespace

void add_stroke_of(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p, bool own,
                   std::vector<Instance>& out) {
    const auto& stroke = p.casting.stroke;
    if (p.vitals.dead || stroke.count < 2) return;
    if (stroke.on_brew) {
        const auto on_surface = [&](std::size_t i) { return vec3(stroke.places[i]); };
        return add_pieces(arena_scene, stroke, number, 0.008, on_surface, out);
    }
    if (own) return;  // in the player's own view the stroke is drawn flat (casting_overlay.h)
    const vec3 tip =
        p.vitals.eye + look_rotation(p.vitals.yaw, p.vitals.pitch) * (wand_tip + vec3(0, 0, -0.1));
    const auto& begin = stroke.points[0];
    const auto in_air = [&](std::size_t i) {
        const auto& point = stroke.points[i];
        const vec3 way(point.x - begin.x, point.y - begin.y, point.z - begin.z);
        return tip + look_rotation(p.vitals.yaw, p.vitals.pitch) * (stroke_scale * way);
    };
    add_pieces(arena_scene, stroke, number, 0.014, in_air, out);
}

void add_recall(const ArenaScene& arena_scene, std::uint32_t number, const PlayerPicture& p,
                std::vector<Instance>& out) {
    constexpr int beads = 14;
    if (p.vitals.dead || !p.casting.recalled) return;
    const vec3 hand = p.vitals.eye + look_rotation(p.vitals.yaw, p.vitals.pitch) * wand_tip,
               way = *p.casting.recalled - hand;
    const double run = 3 * p.casting.reading.age_s;
    for (int i = 0; i < beads; ++i) {
        const double share = 1 - std::fmod(run + static_cast<double>(i) / beads, 1.0);
        out.push_back(bead_at(arena_scene, hand + share * way, 0.03F + 0.05F * static_cast<float>(share),
                              team_colours(number).light, 0.9F));
    }
}

// ---- The shield -------------------------------------------------------------------------------------------

namespace {

constexpr fvec3 shell_size{0.72F, 1.12F, 0.72F};  ///< half axes of a shield's shell (m)

/// Brightness of a shell that flashes because it absorbed harm, 0 to 1.
float flash_of(const CastingPicture& casting) {
    return static_cast<float>(std::clamp(1 - casting.since_flash_s / flash_apart_seconds, 0.0, 1.0));
}

}  // namespace

void add_shell(const ArenaScene& arena_scene, const PlayerPicture& p, double time,
               std::vector<Instance>& out) {
    constexpr int meridians = 6, steps = 9;
    if (p.vitals.dead || !(p.casting.ward > 0)) return;
    const fvec3 light = (0.55F + 0.9F * flash_of(p.casting)) * colour(0x9AF0E0);
    const auto place = [&](int meridian, double share) {
        const double angle = 2 * pi * meridian / meridians + 0.3 * time, tilt = pi * (share - 0.5);
        return p.vitals.centre + vec3(shell_size) * vec3(std::cos(tilt) * std::cos(angle), std::sin(tilt),
                                                         std::cos(tilt) * std::sin(angle));
    };
    const double high = 0.12 + 0.88 * p.casting.ward_share;
    for (int m = 0; m < meridians; ++m) {
        for (int i = 0; i < steps; ++i) {
            const double from = high * i / steps, to = high * (i + 1) / steps;
            add_beam(arena_scene, place(m, from), place(m, to), 0.012, light, out);
        }
    }
}

void add_shell_mist(const ArenaScene& arena_scene, const PlayerPicture& p, std::vector<Instance>& out) {
    if (p.vitals.dead || !(p.casting.ward > 0)) return;
    const auto share = static_cast<float>(p.casting.ward_share);
    out.push_back({.mesh = arena_scene.bead,
                   .model = glm::scale(render::translated(fvec3(p.vitals.centre)), shell_size),
                   .tint = (0.5F + 0.7F * flash_of(p.casting)) * colour(0x9AF0E0),
                   .glow = 0.12F + 0.2F * share});
}

// ---- Fog and dust -----------------------------------------------------------------------------------------

void add_fog(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    constexpr int balls = 20;
    for (const auto& fog : picture.fogs) {
        for (int i = 0; i < balls; ++i) {
            // Positions on a spiral over a hemisphere, so that the cloud has no holes from any side.
            const double up = (i + 0.5) / balls, angle = 2.399963 * i + 0.05 * picture.played_s;
            const double out_by = (i % 4 == 0 ? 0.2 : 0.62) * std::sqrt(1 - up * up);
            const vec3 way(out_by * std::cos(angle), 0.6 * up - 0.25, out_by * std::sin(angle));
            const double size = fog.radius * (0.46 + 0.04 * std::sin(picture.played_s + i));
            out.push_back(bead_at(arena_scene, fog.place + fog.radius * way, static_cast<float>(size),
                                  colour(0xB8B0C8), static_cast<float>(0.85 * fog.strength)));
        }
    }
}

void add_dust(const ArenaScene& arena_scene, const Picture& picture, std::vector<Instance>& out) {
    constexpr int puffs = 16;
    for (std::uint32_t c = 0; c < picture.cast_count; ++c) {
        const auto& cast = picture.casts[c];
        if (cast.sign != SpellSign::dust || cast.age_s >= push_seconds) continue;
        const double age = cast.age_s / push_seconds, yaw = picture.wizards[cast.player % players].vitals.yaw;
        for (int i = 0; i < puffs; ++i) {
            const double aside = 0.6 * (2.0 * (i % 8) / 7 - 1), far = (0.5 + 4.7 * age) * (i < 8 ? 1 : 0.7);
            const vec3 way = rotation({0, 1, 0}, yaw - aside) * vec3(0, 0, -far);
            const vec3 at = cast.place + way + vec3(0, i < 8 ? -0.6 : 0.1 * (i % 3), 0);
            out.push_back(bead_at(arena_scene, at, static_cast<float>(0.25 + 0.5 * age), colour(0xD8C8A8),
                                  static_cast<float>(0.5 * cast.strength * (1 - age))));
        }
    }
}

void add_spell_mists(const ArenaScene& arena_scene, const Picture& picture, std::uint32_t viewer,
                     std::vector<Instance>& out) {
    for (std::uint32_t player = 0; player < players; ++player)
        if (player != viewer) add_shell_mist(arena_scene, picture.wizards[player], out);
    add_fog(arena_scene, picture, out);
    add_dust(arena_scene, picture, out);
    add_tool_mists(arena_scene, picture, out);
}

}  // namespace thaum::game::inline scene
