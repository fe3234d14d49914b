#include "game/hud/view_overlay.h"

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "game/data/event_words.h"
#include "game/data/teams.h"
#include "game/hud/body_figure.h"
#include "game/hud/casting_overlay.h"
#include "game/hud/feed_overlay.h"
#include "game/hud/overlay.h"
#include "game/hud/rim_card.h"
#include "game/hud/station_card.h"
#include "game/hud/station_strip.h"
#include "game/hud/stroke_words.h"
#include "game/hud/wand_icon.h"
#include "game/picture/force_colour.h"

namespace thaum::game::inline hud {
namespace {

using render::Align;
using render::ArcItem;
using render::colour;
using render::LineItem;
using render::Overlay;
using render::RectItem;

constexpr float arc_start = -2.3561945F;  // start angle of the arc for the health, which is open at the
                                          // bottom (rad)
constexpr float arc_sweep = 4.712389F;
constexpr double low_health = 25;    // health below which the health is drawn as low (HP)
constexpr double hit_seconds = 0.3;  // time for which the hit mark is shown (s)
constexpr double warning_seconds = 0.9;
constexpr double gift_seconds = 2;

// Corners ---------------------------------------------------------------------------------------------------

/// Adds a heart, white with a dark edge.
void add_heart(Overlay& out, fvec2 centre, float size) {
    const auto heart = [&](float s, fvec4 paint) {
        for (const float side : {-0.5F, 0.5F})
            out.items.emplace_back(
                ArcItem{centre + size * fvec2(side, -0.25F), 0, 0.55F * s, 0, whole_turn, paint});
        const float wide = 0.5F * size + 0.53F * s;
        out.items.emplace_back(render::TriangleItem{centre + fvec2(-wide, -0.1F * size),
                                                    centre + fvec2(wide, -0.1F * size),
                                                    centre + fvec2(0, 0.2F * size + 0.8F * s), paint});
    };
    heart(1.5F * size, paints.dark);
    heart(size, paints.white);
}

/// Radii of the arcs for the health (HUD units). The arc for the focus, if there is one, lies inside them.
struct HealthArcs {
    float inner{27}, outer{35};
    float extra_inner{22}, extra_outer{25};  ///< arc of health above the initial value
    /// Height of the number's top above the middle, and its text size (HUD units)
    float number_lift{14}, number_size{22};
};
constexpr HealthArcs with_focus{29, 36, 37, 39.5F, 19, 19};

/// Adds the halves of the Great Work (two things that win a round if held together) that the player holds, in
/// the upper corners of the health's box: the potion Azoth as the left half of a disc, and the Lens as the
/// right half with a dot, so that both together make a whole.
void add_halves(Overlay& out, const PlayerPicture& p, const ViewLayout& l) {
    const float u = l.unit, radius = 8 * u;
    const auto gold = colour(0xFFD060, 1.0F);
    const auto half = [&](fvec2 centre, float start) {
        out.items.emplace_back(ArcItem{centre, 0, radius + 1.5F * u, 0, whole_turn, paints.dark});
        out.items.emplace_back(ArcItem{centre, 0, radius, start, whole_turn / 2, gold});
        out.items.emplace_back(ArcItem{centre, radius - 1.5F * u, radius, 0, whole_turn, gold});
    };
    const fvec2 inset(radius + 2 * u, radius + 2 * u);
    if (p.stations.work_half) half(l.health.low + inset, whole_turn / 2);
    if (!p.stations.work.lens) return;
    const fvec2 lens(l.health.high.x - inset.x, l.health.low.y + inset.y);
    half(lens, 0);
    out.items.emplace_back(ArcItem{lens, 0, 3 * u, 0, whole_turn, paints.white});
}

void add_health(Overlay& out, const PlayerPicture& p, std::uint32_t team, const ViewLayout& l) {
    const float u = l.unit;
    const fvec2 centre = (l.health.low + l.health.high) / 2.0F;
    const auto arcs = p.casting.there ? with_focus : HealthArcs{};
    const double share = std::clamp(p.vitals.health / std::max(p.vitals.health_full, 1.0), 0.0, 1.0);
    const double extra = std::clamp(
        (p.vitals.health - p.vitals.health_full) / std::max(p.vitals.health_cap - p.vitals.health_full, 1.0),
        0.0, 1.0);
    out.items.emplace_back(ArcItem{centre, 0, arcs.outer * u + 2 * u, 0, whole_turn, paints.panel});
    out.items.emplace_back(
        ArcItem{centre, arcs.inner * u, arcs.outer * u, arc_start, arc_sweep, paints.track});
    const bool low = p.vitals.health > 0 && p.vitals.health < low_health;
    const auto paint = low ? paints.red : opaque(team_colours(team).glow);
    const auto arc = [&](float inner, float outer, double part, fvec4 of) {
        if (part > 0)
            out.items.emplace_back(
                ArcItem{centre, inner * u, outer * u, arc_start, arc_sweep * static_cast<float>(part), of});
    };
    if (low) {  // not only red, but also edges and a heart, for players who do not see red well
        arc(arcs.inner - 3, arcs.outer + 3, share, paints.dark);
        arc(arcs.inner - 1.5F, arcs.outer + 1.5F, share, paints.white);
        add_heart(out, centre - fvec2(0, (arcs.number_lift + 5) * u), 5 * u);
    }
    arc(arcs.inner, arcs.outer, share, paint);
    arc(arcs.extra_inner, arcs.extra_outer, extra, paints.white);
    if (p.casting.there) add_focus(out, p.casting, centre, u);
    if (p.vitals.shielded)
        out.items.emplace_back(ArcItem{centre, 37 * u, 40 * u, 0, whole_turn, colour(0x9AF0E0, 1.0F)});
    add_text(out, text(static_cast<int>(std::ceil(p.vitals.health))), centre - fvec2(0, arcs.number_lift * u),
             arcs.number_size * u, paints.white, Align::centre);
    add_mark(out, team, centre + fvec2(0, 27 * u), 7 * u);
    add_halves(out, p, l);
}

/// Adds the strip of wands, with the name of the wand in hand and its energy above.
void add_wands(Overlay& out, const Picture& picture, const ControlNames& controls, std::uint32_t player,
               const ViewLayout& l) {
    const auto& p = picture.wizards[player];
    if (p.wand.name.empty()) return;
    const auto& strip = l.strip;
    const float u = strip_unit(l);
    out.items.emplace_back(RectItem{strip.low, strip.high, paints.panel, 8 * u});
    add_wand_strip(out,
                   {.wands = picture.shown->wands,
                    .charges = p.wand.charges,
                    .controls = controls.wands,
                    .next_control = controls.next_wand,
                    .in_hand = p.wand.number,
                    .columns = static_cast<std::size_t>(l.strip_columns),
                    .refilled = p.stations.refilled,
                    .full = opaque(team_colours(player).glow)},
                   strip.low + u * fvec2(strip_margin, strip_head - 1), u);
    const float middle = strip.low.x + 0.66F * (strip.high.x - strip.low.x);
    const Panel name{strip.low + u * fvec2(8, 2), {middle, strip.low.y + u * strip_head}};
    add_text_in(out, name, capitalised(p.wand.name), 14 * u, paints.soft, Align::left);
    const bool empty = p.wand.energy < picture.shown->wands[p.wand.number].energy_cost;
    const Panel energy{{middle, strip.low.y + 2 * u}, {strip.high.x - 8 * u, strip.low.y + u * strip_head}};
    add_text_in(out, energy, empty ? "empty" : text(static_cast<int>(std::floor(p.wand.energy))), 14 * u,
                empty ? paints.light_red : paints.white, Align::right);
}

// Crosshair -------------------------------------------------------------------------------------------------

/// Draws shapes around the crosshair. All lengths that its functions take are in HUD units.
struct Pen {
    Overlay& out;
    fvec2 centre;
    float unit{};

    void line(fvec2 from, fvec2 to, float width, fvec4 paint) const {
        out.items.emplace_back(LineItem{centre + unit * from, centre + unit * to, width, paint});
    }
    /// Draws a line with a dark edge.
    void edged(fvec2 from, fvec2 to, fvec4 paint) const {
        const float width = std::max(1.5F, 1.6F * unit);
        const fvec2 more = 0.5F * glm::normalize(to - from);
        line(from - more, to + more, width + 2, fvec4(fvec3(paints.dark), 0.6F * paint.a));
        line(from, to, width, paint);
    }
    void ring(float inner, float outer, float start, float sweep, fvec4 paint) const {
        out.items.emplace_back(ArcItem{centre, inner * unit, outer * unit, start, sweep, paint});
    }
};

/// Adds a symbol for what the wand would do with the thing under the crosshair. Each case has its own shape.
void add_target(const Pen& pen, const PlayerPicture& p, std::uint32_t foe) {
    const auto corners = [&](float from, float to, fvec4 paint) {
        for (const fvec2 way : {fvec2(1, 1), fvec2(1, -1), fvec2(-1, 1), fvec2(-1, -1)}) {
            pen.edged(from * way, way * fvec2(from, to), paint);
            pen.edged(from * way, way * fvec2(to, from), paint);
        }
    };
    switch (p.wand.target.kind) {
        case TargetKind::nothing: break;
        case TargetKind::foe: corners(13, 7, opaque(team_colours(foe).light)); break;
        case TargetKind::take: pen.ring(12, 14.5F, 0, whole_turn, paints.white); break;
        case TargetKind::hook: pen.ring(12, 14.5F, -0.9F, 1.8F, paints.white); break;
        case TargetKind::too_far:
            for (int i = 0; i < 4; ++i)
                pen.ring(12, 14, 0.4F + 1.5708F * static_cast<float>(i), 0.77F, paints.soft);
            break;
        case TargetKind::too_heavy:
            pen.ring(12, 14, 0, whole_turn, paints.light_red);
            pen.edged({-9, 9}, {9, -9}, paints.light_red);
            break;
    }
}

/// The warning that the player was given just now; empty if there is none.
std::string_view warning_of(const Picture& picture, const PlayerPicture& p) {
    if (p.senses.since_warning_s >= warning_seconds) return {};
    return row_of(picture.shown->events, p.senses.warning).caption;
}

constexpr float warning_size = 14, warning_top = 16;  // text size of a warning, and its distance below the
                                                      // crosshair (HUD units)

/// Whether there is room for a warning below the crosshair. If not, the warning becomes the first one of the
/// messages.
bool warns_at_crosshair(const ViewLayout& l) {
    return l.ring >= (warning_top + FittedWords::line_spacing * warning_size) * l.unit;
}

/// Text below the crosshair: a warning, or the name of what is under the crosshair.
std::string_view words_below(const Picture& picture, const PlayerPicture& p, const ViewLayout& l) {
    if (const auto warning = warning_of(picture, p); !warning.empty())
        return warns_at_crosshair(l) ? warning : std::string_view();
    switch (p.wand.target.kind) {
        case TargetKind::too_far: return "too far";
        case TargetKind::too_heavy: return "too heavy";
        case TargetKind::take:
            return p.wand.target.mass_share < 0.15  ? "light"
                   : p.wand.target.mass_share < 0.5 ? "medium"
                                                    : "heavy";
        default: return {};
    }
}

void add_crosshair(Overlay& out, const Picture& picture, std::uint32_t player, const ViewLayout& l) {
    const auto& p = picture.wizards[player];
    const Pen pen{out, l.centre, std::min(l.unit, l.ring / 24)};
    // The view of a wizard at work is turned to the work of the hand, and no wand aims, so there is no
    // crosshair.
    if (!p.stations.scrying.scries && !p.stations.carving.carves)
        for (const fvec2 way : {fvec2(1, 0), fvec2(-1, 0), fvec2(0, 1), fvec2(0, -1)})
            pen.edged(5.0F * way, 11.0F * way, paints.white);
    add_target(pen, p, 1 - player);
    if (p.wand.readiness > 0) {
        pen.ring(14, 17.5F, 0, whole_turn, paints.track);
        pen.ring(14, 17.5F, 0, whole_turn * static_cast<float>(p.wand.readiness), paints.white);
    }
    if (p.senses.since_hit_s < hit_seconds) {
        for (const fvec2 way :
             {fvec2(0.707F), fvec2(-0.707F), fvec2(0.707F, -0.707F), fvec2(-0.707F, 0.707F)})
            pen.edged(9.0F * way, 18.0F * way, colour(0xFFE08A, 1.0F));
    }
    const auto words = words_below(picture, p, l);
    const bool warned = !warning_of(picture, p).empty();
    const float top = l.centre.y + warning_top * pen.unit, half = 0.9F * l.ring;
    const Panel box{{l.centre.x - half, top}, {l.centre.x + half, l.centre.y + l.ring}};
    const auto lines = fit(words, (warned ? warning_size : 11.0F) * l.unit, box.high - box.low);
    if (!words.empty()) add_plate(out, box, top, lines, warned ? paints.light_red : paints.white);
}

/// Direction of a vector in the player's view, counted clockwise from straight ahead (rad).
float bearing(const PlayerPicture& p, vec3 towards) {
    const vec3 local = rotation({0, 1, 0}, -p.vitals.yaw) * towards;
    return static_cast<float>(std::atan2(local.x, -local.z));
}

/// Adds arcs towards what has hurt the player: red between a light and a dark edge, so that they stand out
/// from any background, with a tip that points outwards.
void add_hurt_marks(Overlay& out, const PlayerPicture& p, const ViewLayout& l) {
    // At a station the middle of the view shows the work of the hand, so the arcs are drawn around that.
    constexpr float round_work = 2.2F;
    const bool works = p.stations.works();
    const float u = l.ring / 66, outer = works ? round_work * l.ring : l.ring;
    for (std::uint32_t i = 0; i < p.senses.hurts; ++i) {
        const auto& mark = p.senses.marks[i];
        const auto left = static_cast<float>(0.9 * std::max(0.0, 1 - mark.age_s / mark_seconds));
        // Arcs for a fall point downwards. Harm without a known direction is shown there, too.
        const bool known = glm::dot(mark.towards, mark.towards) > 0.5;
        const float angle = known ? bearing(p, mark.towards) : whole_turn / 2;
        const auto arc = [&](float from, float to, float half, fvec3 paint) {
            out.items.emplace_back(ArcItem{l.centre, outer - from * u, outer - to * u, angle - half, 2 * half,
                                           opaque(paint, left)});
        };
        arc(14, 0, 0.36F, fvec3(paints.dark));
        arc(12.5F, 1.5F, 0.34F, fvec3(paints.white));
        arc(11, 3, 0.32F, fvec3(paints.red));
    }
}

// Messages --------------------------------------------------------------------------------------------------

/// Message about a problem of the arm (a real force-feedback device) that the player must solve. Empty if
/// there is none, and for a player without an arm, who feels no forces. `told`: true if the arm's driver has
/// reported the fault in its own words.
std::string_view fault_of(const ForcePicture& force, bool told) {
    using haptics::SafetyCause;
    switch (force.arm) {
        case ArmCondition::none: return {};
        case ArmCondition::gone:
            return told ? "Mouse and keys play on" : "The arm does not answer: mouse and keys play on";
        case ArmCondition::back: return "The arm is back: hold it still";
        default: break;
    }
    switch (force.cause) {
        case SafetyCause::shut_off:
            return "Forces are shut off after a fault: the emergency key brings them back";
        case SafetyCause::panic: return "All forces off: the emergency key brings yours back";
        default: return {};
    }
}

/// Caption about the force on the hand, such as a limit that acts, for a player with an arm (a real
/// force-feedback device); empty if there is none.
std::string_view caption_of(const ForcePicture& force) {
    using haptics::SafetyCause;
    if (force.arm == ArmCondition::none) return {};
    if (force.arm == ArmCondition::clutched) return "Clutch: the arm moves free of the hand";
    switch (force.cause) {
        case SafetyCause::warm: return "Forces are weaker for a while: they were strong for too long";
        case SafetyCause::stale: return "Forces fade: the game or the arm is late";
        case SafetyCause::over_speed: return "Forces wait until the hand is slower";
        case SafetyCause::waiting: return "Forces wait until the pull is small";
        default: return {};
    }
}

struct Message {
    std::string words;
    fvec4 paint{};
};

/// Returns all messages to a player, the most important first.
std::vector<Message> messages_to(const Picture& picture, const HudSettings& settings, std::uint32_t player,
                                 const ViewLayout& l) {
    const auto& p = picture.wizards[player];
    const auto& device_message = settings.device_messages[player];
    std::vector<Message> all;
    const auto add = [&](std::string words, fvec4 paint) {
        if (!words.empty()) all.push_back({std::move(words), paint});
    };
    if (!p.vitals.dead && !warns_at_crosshair(l)) add(std::string(warning_of(picture, p)), paints.light_red);
    const bool captions = settings.captions[player];
    const auto fault = fault_of(p.senses.force, !device_message.empty());
    add(std::string(fault), paints.white);
    if (captions && fault.empty()) add(std::string(caption_of(p.senses.force)), paints.white);
    add(device_message, paints.light_red);
    if (p.vitals.dead) return all;
    const auto stroke = stroke_caption(p.casting, *picture.shown, settings.controls[player]);
    add(stroke.words, stroke.failed ? paints.light_red : paints.white);
    const bool given = captions && p.senses.since_gift_s <= gift_seconds;
    auto gift = given ? event_words(row_of(picture.shown->events, p.senses.gift.kind).caption, p.senses.gift,
                                    settings.names, {}, *picture.shown)
                      : std::string();
    gift = with_controls(gift, settings.controls[player], *picture.shown);
    const bool fault_of_brew = p.senses.gift.kind == EventKind::brew_fault;
    if (fault_of_brew) add(gift, paints.light_red);
    if (const auto prompt = prompt_of(p, settings.controls[player])) {
        const float strength = strength_of(*prompt, player, settings.prompts[player], settings.prompt_uses);
        if (strength > 0) add(prompt->words, fvec4(fvec3(paints.white), strength));
    }
    add(std::string(words_of_missed_station(picture.tick, player, settings.prompt_uses)), paints.white);
    if (!has_card(p) && captions) {
        if (!p.stations.carries.empty())
            add(text("Carrying the ", p.stations.carries, ": drop it in the cauldron"), paints.white);
        add(words_of_potions(p), paints.soft);
    }
    // That the probe is near the orb's hidden core needs no message while the card at the orb says it, with
    // the remaining time.
    const bool at_core = p.senses.gift.kind == EventKind::core_near && p.stations.scrying.core_near;
    if (!fault_of_brew && !at_core) add(gift, paints.white);
    return all;
}

/// Adds the messages from the bottom of a box upwards, as many as fit.
void add_messages(Overlay& out, const std::vector<Message>& messages, const Panel& box, float unit) {
    const float size = std::floor(15 * unit), gap = 3 * unit;
    float bottom = box.high.y;
    for (const auto& message : messages) {
        const fvec2 room(box.high.x - box.low.x - size, bottom - box.low.y);
        const bool first = bottom >= box.high.y;
        if (!first && room.y < FittedWords::line_spacing * size) return;
        const auto words = fit(message.words, size, room);
        if (!first && words.size < size) return;
        const float top = bottom - words.height();
        add_plate(out, box, top, words, message.paint);
        bottom = top - gap;
    }
}

/// Adds the card, the panel of a player at cauldron, orb or crystal, beside the ring around the crosshair or
/// below it, wherever it is more readable. Returns the box that is left for messages. `said`: there are
/// messages.
Panel add_card(Overlay& out, const Picture& picture, const HudSettings& settings, std::uint32_t player,
               const ViewLayout& l, bool said) {
    const float gap = 3 * l.unit;
    const auto card = card_of(picture, settings, player);
    const auto beside = fit_card(card, l.aside.high - l.aside.low, l.unit);
    auto below = fit_card(card, l.messages.high - l.messages.low, l.unit);
    if (fits_better(beside, below)) {
        // The card stands at the right, so that the foe beyond the bowl stays visible.
        add_rim_card(out, card, beside, {l.aside.high.x - beside.size.x, l.aside.low.y}, picture.played_s);
        return l.messages;
    }
    for (const float em : {12.0F, std::floor(15 * l.unit)}) {
        const float line = said ? FittedWords::line_spacing * em + gap : 0;
        const auto less = fit_card(card, l.messages.high - l.messages.low - fvec2(0, line), l.unit);
        if (says_all(less)) below = less;
    }
    const fvec2 low((l.messages.low.x + l.messages.high.x - below.size.x) / 2,
                    l.messages.high.y - below.size.y);
    add_rim_card(out, card, below, low, picture.played_s);
    const Panel above{l.messages.low, {l.messages.high.x, low.y - gap}};
    return holds_line(l.aside) && !holds_line(above) ? l.aside : above;
}

/// Adds the card (the panel of a player at cauldron, orb or crystal), and the messages in the room left by
/// the card.
void add_words_below(Overlay& out, const Picture& picture, const HudSettings& settings, std::uint32_t player,
                     const ViewLayout& l) {
    const auto& p = picture.wizards[player];
    const auto messages = messages_to(picture, settings, player, l);
    const bool card = !p.vitals.dead && has_card(p);
    const auto box = card ? add_card(out, picture, settings, player, l, !messages.empty()) : l.messages;
    if (!card || holds_line(box)) add_messages(out, messages, box, l.unit);
}

// Forces ----------------------------------------------------------------------------------------------------

/// Plots the force on the hand over the last two seconds, the newest at the right.
void add_force_plot(Overlay& out, const ForcePicture& force, const ViewLayout& l) {
    const fvec2 size = l.forces.high - l.forces.low;
    const float u = size.x / forces_wide;
    out.items.emplace_back(RectItem{l.forces.low, l.forces.high, paints.panel, 6 * u});
    const auto columns = static_cast<float>(force.strongest.size());
    const float column = (size.x - 12 * u) / columns, high = 46 * u;
    const fvec2 low(l.forces.low.x + 6 * u, l.forces.high.y - 6 * u);
    const auto cap = static_cast<float>(std::max(force.cap, 1e-6));
    for (std::size_t i = 0; i < force.strongest.size(); ++i) {
        const float share = std::min(force.strongest[i] / cap, 1.0F);
        const fvec2 foot = low + fvec2(static_cast<float>(i) * column, 0);
        if (share > 0)
            out.items.emplace_back(RectItem{foot - fvec2(0, std::max(1.0F, share * high)),
                                            foot + fvec2(column, 0),
                                            opaque(force_colour(static_cast<double>(share))), 0});
    }
    const float current = *std::max_element(force.strongest.end() - 8, force.strongest.end());
    add_text_in(out, {l.forces.low + u * fvec2(6, 5), {l.forces.high.x - 6 * u, low.y - high}},
                text(fixed(std::min(static_cast<double>(current), force.cap), 2), " of ", fixed(force.cap, 2),
                     " N, +", fixed(1000 * force.created, 1), " mJ"),
                12 * u, paints.white, Align::left);
}

/// Shows the name of the strongest force on the hand, with a bar that is full at the player's limit.
void add_force_word(Overlay& out, const ForcePicture& force, const ViewLayout& l) {
    constexpr double least = 0.05;  // share of the limit below which no force is named
    const double share = std::min(force.share(), 1.0);
    if (force.source.empty() || share < least) return;
    const float u = (l.forces.high.x - l.forces.low.x) / force_word_wide;
    const fvec2 low = l.forces.low, high = low + u * fvec2(force_word_wide, force_word_high);
    out.items.emplace_back(RectItem{low, high, paints.panel, 6 * u});
    const fvec2 bar = low + u * fvec2(6, 19), size = u * fvec2(84, 4);
    out.items.emplace_back(RectItem{bar, bar + size, paints.track, 2 * u});
    out.items.emplace_back(RectItem{bar, bar + fvec2(static_cast<float>(share) * size.x, size.y),
                                    opaque(force_colour(share)), 2 * u});
    add_text_in(out, {low + u * fvec2(6, 2), {high.x - 6 * u, low.y + 19 * u}}, force.source, 12 * u,
                paints.white, Align::left);
}

/// Adds the figure of the body while the body feels something.
void add_felt(Overlay& out, const PlayerPicture& p, const ViewLayout& l) {
    constexpr double shown_s = 0.8;  // time for which the figure stays after the body has felt something
    if (p.senses.since_felt_s <= shown_s) add_figure(out, l.figure, p.senses.felt);
}

/// Adds words about sounds and effects, the newest at the bottom, as many as fit. In a narrow panel each
/// entry has up to two lines.
void add_heard(Overlay& out, const PlayerPicture& p, HeardWish wish, const ViewLayout& l) {
    const float u = l.unit, inset = 6 * u, max_high = 2 * heard_line_high * u;
    const float room = l.heard.high.x - l.heard.low.x - 2 * inset;
    float bottom = l.heard.high.y;
    for (std::uint32_t i = p.senses.heard_lines; i > 0; --i) {
        const auto& heard = p.senses.heard.at(i - 1);
        if (!wants(wish, heard)) continue;
        const float left = bottom - l.heard.low.y;
        if (left < heard_line_high * u - 0.5F) return;
        const auto fitted = fit(words_of(heard), 13 * u, {room, std::min(left, max_high)});
        // Older entries are left out rather than drawn in tiny text.
        if (bottom < l.heard.high.y && fitted.size < 10 * u) return;
        float wide = 0;
        for (const auto& line : fitted.lines)
            wide = std::max(wide, std::min(room, width_of(line, fitted.size)));
        const float top = bottom - fitted.height();
        out.items.emplace_back(RectItem{
            {l.heard.low.x, top}, {l.heard.low.x + wide + 2 * inset, bottom - u}, paints.panel, 4 * u});
        fvec2 corner(l.heard.low.x + inset, top);
        for (const auto& line : fitted.lines) {
            add_text_in(out, {corner, corner + fvec2(room, fitted.line_height())}, line, fitted.size,
                        heard.important ? paints.white : paints.soft, Align::left);
            corner.y += fitted.line_height();
        }
        bottom = top;
    }
}

void add_death(Overlay& out, const PlayerPicture& p, const ViewLayout& l) {
    add_veil(out, l.view, colour(0x0C0616, 0.5F));
    const float half = 0.46F * static_cast<float>(l.view.width);
    add_text_in(out, {l.centre - fvec2(half, 18 * l.unit), l.centre + fvec2(half, 18 * l.unit)},
                text("Resurrection in ", fixed(p.vitals.returns_in_s, 1), " s"), 24 * l.unit, paints.white,
                Align::centre);
}

/// Adds the countdown to the start in place of the crosshair.
void add_countdown(Overlay& out, int seconds, float size, const ViewLayout& l) {
    add_text(out, text(seconds), l.centre - fvec2(0, 0.7F * size), size, paints.white, Align::centre);
}

}  // namespace

void add_view_overlay(Overlay& out, const Picture& picture, const HudSettings& settings, std::uint32_t player,
                      const HudLayout& layout) {
    const auto& l = *layout.views[player];
    const auto& p = picture.wizards[player];
    const int count = seconds_to_start(picture);
    const bool plays = picture.phase == Phase::playing && !picture.paused && count == 0;
    if (!p.vitals.dead) add_fog_veil(out, picture, player, l);
    if (count > 0) add_countdown(out, count, layout.count_size, l);
    if (plays && p.vitals.dead) add_death(out, p, l);
    if (plays && !p.vitals.dead) {
        add_crosshair(out, picture, player, l);
        add_ward(out, p.casting, l);
        add_free_trail(out, p.casting, player, l);
        add_stroke(out, p.casting, *picture.shown, player, l);
        add_force_band(out, p.casting, l);
        add_hurt_marks(out, p, l);
    }
    if (plays) add_words_below(out, picture, settings, player, l);
    add_health(out, p, player, l);
    add_text_on_plate(out, l.name, name_of(settings.names, player), 14 * l.unit,
                      opaque(team_colours(player).light), Align::left);
    if (plays && !p.vitals.dead && p.casting.stroke.drawing)
        add_spell_strip(out, picture, settings.controls[player], player, l);
    else if (!plays || !add_station_strip(out, picture, settings.controls[player], player, l))
        add_wands(out, picture, settings.controls[player], player, l);
    if (plays) add_feed(out, picture, settings.names, player, l);
    if (plays && !p.vitals.dead) add_heard(out, p, settings.heard[player], l);
    if (plays && settings.figure[player]) add_felt(out, p, l);
    if (settings.forces)
        add_force_plot(out, p.senses.force, l);
    else if (plays && !p.vitals.dead)
        add_force_word(out, p.senses.force, l);
}

}  // namespace thaum::game::inline hud
