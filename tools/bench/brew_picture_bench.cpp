// What pictures of the brew cost: the same picture of the court with the brew and without, by turns in the same run, from where
// players start and from where they stir; and making texels and skin of it.
#include <cstdio>
#include <optional>

#include "core/file.h"
#include "game/bots/duel.h"
#include "game/hud/brew_look.h"
#include "game/hud/hud.h"
#include "render/context.h"
#include "render/perceptual.h"
#include "render/renderer.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using render::Quality;

constexpr render::Size window{1280, 720};
constexpr double step = 0.016;  // s, of the fluid
constexpr std::array places{"start", "beside"};

struct BrewScene {
    render::Offscreen context;
    std::optional<render::Renderer> renderer;  // goes before its context
    game::Court court;
    std::array<game::Picture, places.size()> pictures;
    game::FrameMemory memory;
    game::CauldronRules rules;
    game::Brew brew;
    game::BrewPicture taken;
    game::BrewLook look;

    /// What a new state of the fluid asks for.
    void show() {
        ++taken.state;
        game::show_brew(taken, {}, look);
    }

    void draw(std::size_t place, Quality quality, bool with_brew) {
        game::make_frame(court, pictures[place], {.quality = quality}, window, memory);
        // What is painted over an empty bowl would hide it.
        for (std::size_t i = 0; i < memory.frame.views.size(); ++i) {
            auto& instances = memory.instances[i];
            std::erase_if(instances, [&](const render::Instance& instance) {
                return instance.mesh == court.bubble ||
                       (court.painted_brew && instance.mesh == *court.painted_brew);
            });
            memory.frame.views[i].instances = instances;
            memory.frame.views[i].volume = with_brew ? &look.volume : nullptr;
        }
        if (with_brew) show();
        renderer->draw(memory.frame);
        do_not_optimise(renderer->read_pixels().rgb.data());
    }
};

/// Two substances, stirred for 3 s by a hand's push that goes round.
Expected<void> stir(BrewScene& scene) {
    auto& brew = scene.brew;
    for (const std::uint32_t ingredient : {0U, 1U}) {
        const vec3 at(ingredient == 0 ? -0.5 : 0.5, -0.25, 0.1);
        if (!game::drop(brew, scene.rules, ingredient, at, 0.4, 0.15))
            return fail("nothing could be dropped in");
    }
    for (int i = 0; i < 180; ++i) {
        const double angle = 2 * pi * step * i;
        const vec3 at = 0.6 * vec3(std::cos(angle), -0.4, std::sin(angle));
        fluid::push(brew.fluid, {at - brew.corner, 0.25, 0.03 * vec3(-std::sin(angle), 0, std::cos(angle))});
        fluid::advance(brew.fluid, step);
        const fluid::SheetProbe probe{{at.x, at.z}, i % 40 < 20 ? -0.03 : 0.1, 0.1};
        fluid::advance(brew.sheet, brew.scratch, {&probe, 1}, step);
    }
    return {};
}

/// Each 2.2 m from the middle, looking at it.
void stand_beside(game::Picture& picture) {
    for (std::size_t p = 0; p < picture.wizards.size(); ++p) {
        auto& w = picture.wizards[p];
        const vec3 at(p == 0 ? -2.0 : 2.0, 0, p == 0 ? 0.9 : -0.9);
        w.eye += at - vec3(w.centre.x, 0, w.centre.z);
        w.centre = {at.x, w.centre.y, at.z};
        w.yaw = std::atan2(at.x, at.z);
        w.pitch = -0.4;
    }
}

Expected<std::unique_ptr<BrewScene>> brew_scene() {
    const auto assets = game::find_assets();
    auto loaded = game::load_match_data(assets, {});
    if (!loaded) return tl::unexpected(loaded.error());
    const auto data = std::make_shared<const game::MatchData>(std::move(*loaded));
    auto duel = game::make_bot_duel(assets, data, {1, 1}, 1);
    if (!duel) return tl::unexpected(duel.error());
    auto context = render::Offscreen::create(window.width, window.height);
    if (!context) return tl::unexpected(context.error());
    context->make_current();
    auto renderer = render::Renderer::create(assets);
    if (!renderer) return tl::unexpected(renderer.error());
    if (!data->cauldron) return fail("the match has no cauldron");
    const auto& rules = *data->cauldron;
    const auto place = game::brew_place(*data->arena.bowl, rules);
    auto brew = game::make_brew(rules, place.basin);
    if (!brew) return tl::unexpected(brew.error());
    auto scene = std::unique_ptr<BrewScene>(new BrewScene{
        std::move(*context), std::move(*renderer), {}, {}, {}, rules, std::move(*brew), {}, {}});
    scene->court = game::make_court(*scene->renderer, *data);
    scene->look = game::make_brew_look(*scene->renderer, place);
    for (auto& picture : scene->pictures) {
        picture = game::make_picture();
        game::take_picture(*duel->match, picture);
    }
    stand_beside(scene->pictures[1]);
    if (auto stirred = stir(*scene); !stirred) return tl::unexpected(stirred.error());
    game::take_brew(scene->brew, rules, 1, scene->taken);
    return scene;
}

void making(BrewScene& scene, const Options& options, Report& report) {
    const std::array contestants{Contestant{.setup = {}, .run = [&] { scene.show(); }}};
    const auto samples = measure(contestants, {.seconds = options.quick ? 0.5 : 2.0});
    const auto& cells = scene.brew.fluid.lattice.cells;
    report.rows.push_back({.area = "render",
                           .name = "brew_texels",
                           .setting = {{"cells", std::int64_t{cells[0]} * cells[1] * cells[2]},
                                       {"sheet", std::string("awake")}},
                           .time_us = times(samples[0]),
                           .is_default = true,
                           .metrics = {{"skin_vertices", static_cast<double>(scene.look.skin.size())}}});
}

void drawing(BrewScene& scene, const Options& options, Report& report) {
    std::vector<Contestant> contestants;
    for (std::size_t place = 0; place < places.size(); ++place) {
        for (std::size_t q = 0; q < render::qualities; ++q) {
            for (const bool with_brew : {false, true})
                contestants.push_back({.setup = {}, .run = [&scene, place, q, with_brew] {
                                           scene.draw(place, static_cast<Quality>(q), with_brew);
                                       }});
        }
    }
    const auto samples = measure(contestants, {.seconds = options.quick ? 8.0 : 40.0, .least = 11});
    const auto first = render::first_quality(scene.renderer->device());
    for (std::size_t i = 0; i < samples.size(); i += 2) {
        const auto place = i / 2 / render::qualities;
        const auto quality = static_cast<Quality>(i / 2 % render::qualities);
        scene.draw(place, Quality::high, true);
        const auto best = scene.renderer->read_pixels();
        scene.draw(place, quality, true);
        report.rows.push_back(
            {.area = "render",
             .name = text("brew_", places[place]),
             .setting = {{"quality", std::string(render::quality_names[static_cast<std::size_t>(quality)])},
                         {"device", scene.renderer->device()}},
             .time_us = times(samples[i + 1]),
             .error = ErrorMeasure{"mean_delta_e_to_high",
                                   render::distance(scene.renderer->read_pixels(), best).mean},
             .is_default = quality == first,
             .metrics = {{"to_without", ratio(samples[i + 1], samples[i])},
                         {"without_us", median(samples[i])}}});
    }
}

}  // namespace

void brew_pictures(const Options& options, Report& report) {
    auto made = brew_scene();
    if (!made) {
        std::fprintf(stderr, "bench: render: %s\n", made.error().message.c_str());
        return;
    }
    making(**made, options, report);
    drawing(**made, options, report);
    (*made)->renderer.reset();
}

}  // namespace thaum::bench
