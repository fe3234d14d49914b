#include "game/hud/hud.h"

#include <algorithm>
#include <cmath>

namespace thaum::game {
namespace {

render::Camera camera_of(const PlayerPicture& player, const HudSettings& settings, const render::Rect& view) {
    const double aspect = view.height > 0 ? static_cast<double>(view.width) / view.height : 1;
    render::Camera camera;
    // Who is dead looks on from where they fell, from a little above.
    const vec3 eye = player.dead ? player.eye + vec3(0, 0.6, 0) : player.eye;
    camera.position = fvec3(eye);
    camera.orientation = fquat(look_rotation(player.yaw, player.pitch));
    camera.fov_y = static_cast<float>(field_of_view(settings.fov, aspect));
    camera.far_plane = 160;
    return camera;
}

void add_view(const Court& court, const Picture& picture, const HudSettings& settings, std::uint32_t player,
              const render::Rect& view, FrameMemory& memory) {
    auto& instances = memory.instances[player];
    auto& lights = memory.lights[player];
    instances.clear();
    const auto* brew = visible_brew(court, picture, picture.wizards[player].eye);
    add_instances(court, picture, player, instances);
    add_power_ups(court.power_ups, picture, picture.wizards[player].eye, instances);
    choose_lights(court, picture, picture.wizards[player].eye, lights);
    memory.frame.views.push_back({.camera = camera_of(picture.wizards[player], settings, view),
                                  .viewport = view,
                                  .instances = instances,
                                  .lights = lights,
                                  .environment = court.environment,
                                  .shades = memory.shades,
                                  .mists = memory.mists,
                                  .blocks = blocks_seen_from(court, picture.wizards[player].eye),
                                  .volume = brew});
}

/// What both views share.
void add_shared(const Court& court, const Picture& picture, FrameMemory& memory) {
    for (auto* list : {&memory.shades, &memory.mists, &memory.fixed_casters, &memory.moving_casters})
        list->clear();
    add_contact_shades(court, picture, memory.shades);
    add_steam(court, picture, memory.mists);
    add_casters(court, picture, memory.fixed_casters, memory.moving_casters);
    memory.frame.casters = {memory.fixed_casters, memory.moving_casters};
}

}  // namespace

double field_of_view(double fov_degrees, double aspect) {
    // The same area of the world in every shape of view: tan(width / 2) tan(height / 2) is kept.
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

std::array<render::Rect, players> views_of(const HudSettings& settings, render::Size size) {
    const render::Rect whole{0, 0, size.width, size.height};
    switch (settings.watch) {
        case Watch::first: return {whole, {}};
        case Watch::second: return {render::Rect{}, whole};
        case Watch::both: break;
    }
    return render::split_window(size.width, size.height, settings.split);
}

void begin_frame(const Court& court, const Picture& picture, const HudSettings& settings, render::Size size,
                 FrameMemory& memory) {
    auto& frame = memory.frame;
    frame.width = size.width;
    frame.height = size.height;
    frame.quality = settings.quality;
    frame.bloom = settings.bloom;
    frame.internal_scale = render::internal_scale_of(settings.quality, size.height);
    frame.views.clear();
    frame.overlay.items.clear();
    add_shared(court, picture, memory);
    show_brew_near(court, picture, {.arrows = settings.forces, .streamlines = settings.forces});
}

const render::Frame& make_frame(const Court& court, const Picture& picture, const HudSettings& settings,
                                render::Size size, FrameMemory& memory) {
    begin_frame(court, picture, settings, size, memory);
    auto& frame = memory.frame;
    const auto views = views_of(settings, size);
    for (std::uint32_t player = 0; player < players; ++player) {
        if (views[player].width > 0 && views[player].height > 0)
            add_view(court, picture, settings, player, views[player], memory);
    }
    make_overlay(picture, settings, size, frame.overlay);
    return frame;
}

}  // namespace thaum::game
