// What a picture of the duel costs at each quality, and how far it is from the best one.
#include <chrono>
#include <cstdio>
#include <optional>

#include "game/bots/duel.h"
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
constexpr Tick between_pictures = 16;  // ms of play: what moves has moved

struct RenderScene {
    render::Offscreen context;
    std::optional<render::Renderer> renderer;  // goes before its context
    game::BotDuel duel;
    game::Court court;
    game::Picture picture = game::make_picture();
    game::FrameMemory memory;

    void advance() {
        duel.run(between_pictures);
        game::take_picture(*duel.match, picture);
    }
    void draw(Quality quality) {
        renderer->draw(game::make_frame(court, picture, {.quality = quality}, window, memory));
        // Nothing is left to be done behind our back: the last pixel is there.
        do_not_optimise(renderer->read_pixels().rgb.data());
    }
};

Expected<std::unique_ptr<RenderScene>> render_scene() {
    const auto assets = game::find_assets();
    auto loaded = game::load_match_data(assets, {.overrides = {"quick.kills=1000", "quick.seconds=36000"}});
    if (!loaded) return tl::unexpected(loaded.error());
    const auto data = std::make_shared<const game::MatchData>(std::move(*loaded));
    auto duel = game::make_bot_duel(assets, data, {1, 1}, 1);
    if (!duel) return tl::unexpected(duel.error());
    auto context = render::Offscreen::create(window.width, window.height);
    if (!context) return tl::unexpected(context.error());
    context->make_current();
    auto renderer = render::Renderer::create(assets);
    if (!renderer) return tl::unexpected(renderer.error());
    auto scene = std::unique_ptr<RenderScene>(new RenderScene{
        std::move(*context), std::move(*renderer), std::move(*duel), {}, game::make_picture(), {}});
    scene->court = game::make_court(*scene->renderer, data->arena, data->wizard);
    scene->duel.run(4000);
    return scene;
}

render::Image picture_at(RenderScene& scene, Quality quality) {
    scene.draw(quality);
    return scene.renderer->read_pixels();
}

Row row_of(RenderScene& scene, Quality quality, const std::vector<double>& samples,
           const render::Image& best) {
    const auto name = render::quality_names[static_cast<std::size_t>(quality)];
    const auto image = picture_at(scene, quality);
    // The shadow map is up to date: once more with movers, for what a frame of a running match draws.
    scene.advance();
    scene.draw(quality);
    const auto s = scene.renderer->statistics();
    constexpr double views = 2;
    return {.area = "render",
            .name = "duel",
            .setting = {{"quality", std::string(name)},
                        {"width", std::int64_t{window.width}},
                        {"height", std::int64_t{window.height}},
                        {"device", scene.renderer->device()}},
            .time_us = times(samples),
            .error = ErrorMeasure{"mean_delta_e_to_high", render::distance(image, best).mean},
            .is_default = quality == render::first_quality(scene.renderer->device()),
            .metrics = {{"triangles_per_view", static_cast<double>(s.triangles) / views},
                        {"draws_per_view", static_cast<double>(s.draws) / views},
                        {"instances_per_view", static_cast<double>(s.instances_drawn) / views},
                        {"culled_per_view", static_cast<double>(s.instances_culled) / views},
                        {"shadow_draws", static_cast<double>(s.shadow_draws)},
                        {"shadow_triangles", static_cast<double>(s.shadow_triangles)}}};
}

}  // namespace

void render(const Options& options, Report& report) {
    auto made = render_scene();
    if (!made) {
        std::fprintf(stderr, "bench: render: %s\n", made.error().message.c_str());
        return;
    }
    auto& scene = **made;
    std::vector<Contestant> contestants;
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        contestants.push_back(
            {.setup = [&scene] { scene.advance(); }, .run = [&scene, quality] { scene.draw(quality); }});
    }
    const auto samples = measure(contestants, {.seconds = options.quick ? 6.0 : 30.0, .least = 15});
    scene.advance();
    for (const auto quality : {Quality::low, Quality::medium, Quality::high}) {
        const auto best = picture_at(scene, Quality::high);
        report.rows.push_back(row_of(scene, quality, samples[static_cast<std::size_t>(quality)], best));
    }
    scene.renderer.reset();
}

}  // namespace thaum::bench
