#include "unit/screen_reader.h"

#include <algorithm>
#include <cmath>

#include "game/hud/layout.h"
#include "game/hud/station_card.h"

namespace thaum::game::screen {
namespace {

constexpr std::uint32_t viewer = 0;
constexpr double far_away = 60;  ///< largest distance at which a person recognises an object (m)

// Texts on the screen ---------------------------------------------------------------------------------------

bool is_in(const game::Panel& box, fvec2 place) {
    return place.x >= box.low.x - 1 && place.x <= box.high.x + 1 && place.y >= box.low.y - 1 &&
           place.y < box.high.y;
}

Part part_of(const game::HudLayout& layout, fvec2 place) {
    const auto& view = *layout.views[viewer];
    if (layout.lesson && is_in(*layout.lesson, place)) return Part::lesson;
    if (is_in(layout.score, place)) return Part::score;
    if (is_in(view.messages, place) || is_in(view.aside, place)) return Part::messages;
    if (is_in(view.strip, place)) return Part::strip;
    if (is_in(view.name, place)) return Part::name;
    if (is_in(view.feed, place)) return Part::feed;
    const fvec2 aside = place - view.centre;
    return std::max(std::abs(aside.x), std::abs(aside.y)) <= view.ring ? Part::crosshair : Part::other;
}

/// Whether a shape darkens the whole window, as it does behind the panel after a round.
bool covers(const render::OverlayItem& item, render::Size size) {
    const auto* veil = std::get_if<render::RectItem>(&item);
    return veil != nullptr && veil->low == fvec2(0) &&
           veil->high == fvec2(static_cast<float>(size.width), static_cast<float>(size.height));
}

/// Calls f(item) for each readable line of text. The dark copy behind each line is skipped.
template <class F>
void each_line(const std::vector<render::OverlayItem>& items, F&& f) {
    constexpr float readable = 0.15F;  // least opacity of readable text
    const render::TextItem* before = nullptr;
    for (const auto& item : items) {
        const auto* line = std::get_if<render::TextItem>(&item);
        const bool copied = line != nullptr && before != nullptr && line->text == before->text;
        if (copied && line->colour.a >= readable) f(*line, item);
        before = copied ? nullptr : line;
    }
}

fvec2 middle_of(const render::TextItem& line) { return line.position + fvec2(0, line.size / 2); }

void read_menu(const Shown& shown, Screen& out) {
    const auto& menu = shown.screen.menu;
    render::Overlay overlay;
    game::add_menu(overlay, menu, shown.size, shown.screen.hud.text_scale);
    each_line(overlay.items, [&](const auto& line, const auto&) {
        const bool chosen = line.text == menu.rows.at(menu.cursor).label;
        out.words.push_back({Part::menu, line.text, middle_of(line), chosen});
    });
}

void read_hud(const Shown& shown, Screen& out) {
    auto hud = shown.screen.hud;
    hud.prompt_uses = shown.prompt_uses;
    render::Overlay overlay;
    game::make_overlay(shown.picture, hud, shown.size, overlay);
    const auto layout = game::lay_out(
        hud, shown.size, shown.picture.shown->wands.size(),
        {.lesson = !shown.picture.practice.lesson.empty(),
         .cards = {game::has_card(shown.picture.wizards[0]), game::has_card(shown.picture.wizards[1])}});
    const bool ended = shown.picture.phase != game::Phase::playing;
    std::size_t veil = overlay.items.size();
    for (std::size_t i = 0; ended && i < overlay.items.size(); ++i)
        if (covers(overlay.items[i], shown.size)) veil = i;
    each_line(overlay.items, [&](const auto& line, const auto& item) {
        const bool above = &item > overlay.items.data() + veil;
        out.words.push_back(
            {above ? Part::result : part_of(layout, line.position), line.text, middle_of(line), false});
    });
    out.crosshair = layout.views[viewer]->centre;
}

// Objects in the view ---------------------------------------------------------------------------------------

/// The viewer's eye and projection.
struct Eye {
    const game::Simulation& match;
    ecs::Entity wizard;
    vec3 place{};
    quat turn{1, 0, 0, 0};
    fvec2 centre{};
    double focal{};  ///< height in the window of an object that is as high as it is far away (px)

    /// Position of a point in the window; std::nullopt: outside the view.
    std::optional<fvec2> drawn(vec3 point) const {
        const vec3 local = glm::conjugate(turn) * (point - place);
        if (local.z > -0.1) return {};
        const fvec2 at = centre + fvec2(focal / -local.z * glm::dvec2(local.x, -local.y));
        const bool inside = at.x >= 0 && at.y >= 0 && at.x < 2 * centre.x && at.y < 2 * centre.y;
        return inside ? std::optional(at) : std::nullopt;
    }
    float height_of(vec3 point, double high) const {
        return static_cast<float>(focal * high / std::max(0.1, glm::distance(point, place)));
    }
    /// Whether nothing hides a point. `thing`, to which the point belongs, does not count.
    bool is_clear(vec3 point, std::optional<std::uint32_t> thing) const {
        const auto hit = match.physics().ray(place, point, physics::all_layers, wizard.index);
        return !hit || (thing && hit->key == *thing) || glm::distance(hit->point, point) < 0.05;
    }
};

Eye eye_of_viewer(const Shown& shown) {
    const auto& player = shown.picture.wizards[viewer];
    const auto& world = shown.match->world();
    const double w = shown.size.width, h = shown.size.height;
    const double up = game::field_of_view(shown.screen.hud.fov, w / h);
    return {.match = *shown.match,
            .wizard = game::wizard_of(world, viewer),
            .place = player.vitals.eye,
            .turn = look_rotation(player.vitals.yaw, player.vitals.pitch),
            .centre = fvec2(w, h) / 2.0F,
            .focal = h / 2 / std::tan(up / 2)};
}

void see(const Eye& eye, std::string_view what, vec3 point, double high, std::optional<std::uint32_t> thing,
         Screen& out) {
    if (glm::distance(point, eye.place) > far_away) return;
    const auto at = eye.drawn(point);
    if (at && eye.is_clear(point, thing)) out.sights.push_back({what, *at, eye.height_of(point, high)});
}

/// Finds the other wizard by the middle of the body, or else by the head.
void see_wizard(const Eye& eye, const game::PlayerPicture& other, double high, Screen& out) {
    if (other.vitals.dead) return;
    const auto thing = game::wizard_of(eye.match.world(), 1 - viewer).index;
    const auto before = out.sights.size();
    see(eye, "wizard", other.vitals.centre, high, thing, out);
    if (out.sights.size() == before) see(eye, "wizard", other.vitals.eye, high, thing, out);
}

double height_of(const game::ShapeKey& key) {
    switch (key.shape) {
        case physics::Shape::box: return 2 * key.size.y;
        case physics::Shape::sphere: return 2 * key.size.x;
        case physics::Shape::mesh: return 1;
        default: return 2 * (key.size.x + key.size.y);
    }
}

/// The name that a person would give to a surface.
std::string_view name_of(game::Surface surface) {
    return surface == game::Surface::bowl ? "cauldron"
                                          : game::surface_names.at(static_cast<std::size_t>(surface));
}

/// Whether a surface belongs to an object that a person would name, and not to the ground or a wall.
bool is_thing(game::Surface surface) { return surface >= game::Surface::bowl; }

void see_things(const Eye& eye, const Shown& shown, Screen& out) {
    const auto& picture = shown.picture;
    see_wizard(eye, picture.wizards[1 - viewer], shown.match->data().wizard.height, out);
    for (const auto& thing : picture.things)
        if (is_thing(thing.key.surface))
            see(eye, name_of(thing.key.surface), thing.position, height_of(thing.key), thing.entity, out);
    const vec3 up(0, 0.3, 0);  // objects to pick up float above their place on the ground
    for (const auto& niche : picture.niches)
        if (niche.there) see(eye, "ingredient", niche.position + up, 0.4, {}, out);
    for (const auto& one : picture.power_ups)
        if (one.returned >= 1)
            see(eye, game::power_up_names.at(static_cast<std::size_t>(one.kind)), one.position + up, 0.4, {},
                out);
}

Surface surface_at(const Eye& eye, fvec2 pixel) {
    const glm::dvec2 aside = glm::dvec2(pixel - eye.centre) / eye.focal;
    const vec3 way = eye.turn * glm::normalize(vec3(aside.x, -aside.y, -1));
    const auto hit =
        eye.match.physics().ray(eye.place, eye.place + far_away * way, physics::all_layers, eye.wizard.index);
    if (!hit) return {{}, static_cast<float>(far_away)};
    const auto& world = eye.match.world();
    const auto met = world.entity(hit->key);
    const auto* look = met ? world.find<game::Look>(met) : nullptr;
    const auto name = look == nullptr ? std::string_view("wizard") : name_of(look->surface);
    return {name, static_cast<float>(hit->fraction * far_away)};
}

void glance_at(const Eye& eye, Screen& out) {
    for (std::size_t row = 0; row < glance_rows; ++row)
        for (std::size_t column = 0; column < glance_columns; ++column) {
            const fvec2 share((static_cast<float>(column) + 0.5F) / glance_columns,
                              (static_cast<float>(row) + 0.5F) / glance_rows);
            out.glance[row][column] = surface_at(eye, 2.0F * eye.centre * share);
        }
}

// Marks around the crosshair --------------------------------------------------------------------------------

void see_arc(const Eye& eye, const game::PlayerPicture& player, Screen& out) {
    if (player.wand.arc_points == 0) return;
    const vec3 end = player.wand.arc.at(player.wand.arc_points - 1);
    const auto at = eye.drawn(end);
    if (at && eye.is_clear(end, {})) out.arc_end = at;
}

void see_hurts(const game::PlayerPicture& player, Screen& out) {
    if (player.senses.hurts == 0) return;
    const auto& mark = player.senses.marks[0];
    if (glm::dot(mark.towards, mark.towards) < 0.5) return;
    const vec3 local = rotation({0, 1, 0}, -player.vitals.yaw) * mark.towards;
    out.hurt_from = static_cast<float>(std::atan2(local.x, -local.z));
}

void see_marks(const Eye& eye, const Shown& shown, Screen& out) {
    const auto& player = shown.picture.wizards[viewer];
    out.mark = player.wand.target.kind;
    out.ring = static_cast<float>(player.wand.readiness);
    out.holds = player.wand.held.has_value();
    out.dead = player.vitals.dead;
    out.horizon = eye.centre.y + static_cast<float>(eye.focal * std::tan(player.vitals.pitch));
    see_arc(eye, player, out);
    see_hurts(player, out);
    const auto& wands = shown.picture.shown->wands;
    out.energy.assign(wands.size(), 0);
    for (std::size_t i = 0; i < wands.size(); ++i)
        out.energy.at(wands[i].slot) =
            static_cast<float>(player.wand.charges.at(i) / std::max(1e-9, wands[i].energy_cap));
}

}  // namespace

std::string Screen::words_of(Part part) const {
    std::string all;
    for (const auto& line : words)
        if (line.part == part) all += all.empty() ? line.text : " " + line.text;
    return all;
}

bool Screen::has_words(Part part) const {
    return std::any_of(words.begin(), words.end(), [&](const Words& line) { return line.part == part; });
}

Screen look_at(const Shown& shown) {
    Screen out;
    out.size = shown.size;
    if (shown.screen.hud.menu || shown.match == nullptr) {
        read_menu(shown, out);
        return out;
    }
    read_hud(shown, out);
    out.shows_view = true;
    const auto eye = eye_of_viewer(shown);
    see_things(eye, shown, out);
    glance_at(eye, out);
    see_marks(eye, shown, out);
    return out;
}

}  // namespace thaum::game::screen
