#include "game/hud/hud.h"

#include <algorithm>
#include <cmath>

namespace thaum::game::inline hud {
namespace {

/// Zooms a view in while its player carves, and out afterwards, within some tenths of a second. If the
/// picture does not directly follow the last one, as after a jump in a replay, the zoom is completed at once.
void come_nearer(NearView& view, const Picture& picture, bool carves) {
    constexpr double whole_way_s = 0.35, max_gap_s = 1;
    const double gone_s = picture.tick >= view.tick ? seconds(picture.tick - view.tick) : max_gap_s;
    view.tick = picture.tick;
    const double step = gone_s < max_gap_s ? gone_s / whole_way_s : 1;
    view.share = std::clamp(view.share + (carves ? step : -step), 0.0, 1.0);
}

/// Field of view in which a crystal fills most of the view's shorter edge (rad).
double field_of_crystal(const CrystalPicture& crystal, vec3 eye, double aspect) {
    // How many lengths of the crystal's edge, at the crystal's distance, half of the view's shorter edge
    // shows.
    constexpr double shown = 0.5;
    const double distance = std::max(glm::length(crystal.middle - eye), crystal.edge / 2);
    return 2 * std::atan(shown * crystal.edge / distance / std::min(aspect, 1.0));
}

render::Camera camera_of(const PlayerPicture& player, double fov) {
    render::Camera camera;
    // A dead player looks from slightly above the place of death.
    const vec3 eye = player.vitals.dead ? player.vitals.eye + vec3(0, 0.6, 0) : player.vitals.eye;
    camera.position = fvec3(eye);
    camera.orientation = fquat(look_rotation(player.vitals.yaw, player.vitals.pitch));
    camera.fov_y = static_cast<float>(fov);
    camera.far_plane = 160;
    return camera;
}

void add_view(const ArenaScene& arena_scene, const Picture& picture, const HudSettings& settings,
              std::uint32_t player, const render::Rect& view, FrameMemory& memory) {
    auto& instances = memory.instances[player];
    auto& lights = memory.lights[player];
    instances.clear();
    const auto* brew = visible_brew(arena_scene, picture, picture.wizards[player].vitals.eye);
    add_instances(arena_scene, picture, player, instances);
    add_power_ups(arena_scene.power_ups, picture, picture.wizards[player].vitals.eye, instances);
    choose_lights(arena_scene, picture, picture.wizards[player].vitals.eye, lights);
    auto& scans = memory.scans[player];
    scans.clear();
    add_crystals(arena_scene, picture, picture.wizards[player].vitals.eye, scans);
    auto& mists = memory.spell_mists[player];
    mists.clear();
    add_spell_mists(arena_scene, picture, player, mists);
    if (!mists.empty()) mists.insert(mists.end(), memory.mists.begin(), memory.mists.end());
    const double aspect = view.height > 0 ? static_cast<double>(view.width) / view.height : 1;
    const double fov = field_of_player(picture, player, field_of_view(settings.fov, aspect), aspect,
                                       memory.near_views[player]);
    memory.frame.views.push_back({.camera = camera_of(picture.wizards[player], fov),
                                  .viewport = view,
                                  .instances = instances,
                                  .lights = lights,
                                  .environment = arena_scene.environment,
                                  .shades = memory.shades,
                                  .mists = mists.empty() ? memory.mists : mists,
                                  .blocks = blocks_seen_from(arena_scene, picture.wizards[player].vitals.eye),
                                  .volume = brew,
                                  .scans = scans});
}

/// Fills in the lists that do not depend on whose view is drawn: the shades under things that touch the
/// ground, steam, and what casts shadows.
void add_shared(const ArenaScene& arena_scene, const Picture& picture, FrameMemory& memory) {
    for (auto* list : {&memory.shades, &memory.mists, &memory.fixed_casters, &memory.moving_casters})
        list->clear();
    add_contact_shades(arena_scene, picture, memory.shades);
    add_steam(arena_scene, picture, memory.mists);
    add_casters(arena_scene, picture, memory.fixed_casters, memory.moving_casters);
    memory.frame.casters = {memory.fixed_casters, memory.moving_casters};
}

}  // namespace

double field_of_player(const Picture& picture, std::uint32_t player, double usual, double aspect,
                       NearView& near_view) {
    const auto& p = picture.wizards[player];
    const bool carves =
        !p.vitals.dead && p.stations.carving.carves && p.stations.carving.crystal < picture.crystals.size();
    come_nearer(near_view, picture, carves);
    if (carves)
        near_view.nearest = std::min(
            usual, field_of_crystal(picture.crystals[p.stations.carving.crystal], p.vitals.eye, aspect));
    return glm::mix(usual, std::min(usual, near_view.nearest), glm::smoothstep(0.0, 1.0, near_view.share));
}

double field_of_view(double fov_degrees, double aspect) {
    // Views of every aspect ratio show an equally large area: tan(width / 2) tan(height / 2) is constant,
    // where width and height are the angles of the view.
    const double wide = std::tan(fov_degrees * radians_per_degree / 2);
    const double area = wide * wide * 9 / 16;
    return 2 * std::atan(std::sqrt(area / aspect));
}

std::vector<std::string> words_over_views(const Simulation& match) {
    Picture picture = make_picture();
    take_picture(match, picture);
    render::Overlay overlay;
    make_overlay(picture, {}, {1280, 720}, overlay);
    std::vector<std::string> words;
    for (const auto& item : overlay.items)
        if (const auto* line = std::get_if<render::TextItem>(&item)) words.push_back(line->text);
    return words;
}

render::Size area_of_views(const HudSettings& settings, render::Size size) {
    if (!settings.replay) return size;
    return {size.width, static_cast<int>(lay_out_replay_bar(settings.text_scale, size).band.low.y)};
}

std::array<render::Rect, players> views_of(const HudSettings& settings, render::Size size) {
    size = area_of_views(settings, size);
    const render::Rect whole{0, 0, size.width, size.height};
    switch (settings.watch) {
        case Watch::first: return {whole, {}};
        case Watch::second: return {render::Rect{}, whole};
        case Watch::both: break;
    }
    return render::split_window(size.width, size.height, settings.split);
}

void begin_frame(const ArenaScene& arena_scene, const Picture& picture, const HudSettings& settings,
                 render::Size size, FrameMemory& memory) {
    auto& frame = memory.frame;
    frame.width = size.width;
    frame.height = size.height;
    frame.quality = settings.quality;
    frame.bloom = settings.bloom;
    const float of_preset = render::internal_scale_of(settings.quality, size.height);
    frame.internal_scale = std::max(settings.resolution * of_preset, 0.25F);  // the least that Frame allows
    frame.views.clear();
    frame.overlay.items.clear();
    add_shared(arena_scene, picture, memory);
    show_brew_near(arena_scene, picture, {.arrows = settings.forces, .streamlines = settings.forces});
    show_stations(arena_scene, picture);
    memory.changes.clear();
    add_mesh_changes(arena_scene, memory.changes);
    frame.changes = memory.changes;
}

const render::Frame& make_frame(const ArenaScene& arena_scene, const Picture& picture,
                                const HudSettings& settings, render::Size size, FrameMemory& memory) {
    begin_frame(arena_scene, picture, settings, size, memory);
    auto& frame = memory.frame;
    const auto views = views_of(settings, size);
    for (std::uint32_t player = 0; player < players; ++player) {
        if (views[player].width > 0 && views[player].height > 0)
            add_view(arena_scene, picture, settings, player, views[player], memory);
    }
    make_overlay(picture, settings, size, frame.overlay);
    return frame;
}

}  // namespace thaum::game::inline hud
