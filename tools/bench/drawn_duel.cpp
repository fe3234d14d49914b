#include "tools/bench/drawn_duel.h"

#include "tools/bench/match_scene.h"
#include "tools/bench/measure.h"

namespace thaum::bench {

Expected<std::unique_ptr<DrawnDuel>> DrawnDuel::create() {
    const auto assets = game::find_assets();
    const auto data = duel_data();
    if (!data) return fail("the data files could not be loaded; see the message above");
    auto duel = game::make_bot_duel(assets, data, {"1", "1"}, 1);
    if (!duel) return duel.error();
    auto context = render::Offscreen::create(window.width, window.height);
    if (!context) return context.error();
    context->make_current();
    auto renderer = render::Renderer::create(assets);
    if (!renderer) return renderer.error();
    auto drawn = std::unique_ptr<DrawnDuel>(
        new DrawnDuel{std::move(*context), std::move(*renderer), std::move(*duel)});
    drawn->arena_scene = game::make_arena_scene(*drawn->renderer, *data);
    return drawn;
}

void DrawnDuel::draw(const render::Frame& frame) {
    renderer->draw(frame);
    do_not_optimise(renderer->read_pixels().rgb.data());
}

}  // namespace thaum::bench
