#include "game/hud/still.h"

#include <algorithm>

#include "game/picture/picture.h"
#include "game/scene/arena_scene.h"
#include "render/context.h"
#include "render/renderer.h"

namespace thaum::game::inline hud {

struct Still::State {
    render::Offscreen context;
    std::optional<render::Renderer> renderer;  // must be destroyed before its OpenGL context
    ArenaScene arena_scene;
    Picture picture = make_picture();
    FrameMemory memory;
};

Still::Still(std::unique_ptr<State> state) : state_(std::move(state)) {}
Still::Still(Still&&) noexcept = default;
Still& Still::operator=(Still&&) noexcept = default;
Still::~Still() = default;

Expected<Still> Still::create(const MatchData& data, const std::filesystem::path& assets, render::Size size) {
    auto context = render::Offscreen::create(size.width, size.height);
    if (!context) return context.error();
    context->make_current();
    auto renderer = render::Renderer::create(assets);
    if (!renderer) return renderer.error();
    auto state =
        std::unique_ptr<State>(new State{std::move(*context), std::move(*renderer), {}, make_picture(), {}});
    state->arena_scene = make_arena_scene(*state->renderer, data);
    return Still(std::move(state));
}

namespace {

void show(const Senses& senses, Picture& picture) {
    for (std::uint32_t p = 0; p < players; ++p) {
        auto& shown = picture.wizards.at(p);
        const auto lines = senses.lines(p);
        shown.senses.heard_lines =
            static_cast<std::uint32_t>(std::min(lines.size(), shown.senses.heard.size()));
        std::copy_n(lines.begin(), shown.senses.heard_lines, shown.senses.heard.begin());
        std::copy_n(senses.felt(p, 0).amplitude.begin(), figure_cells, shown.senses.felt.begin());
        shown.senses.since_felt_s = senses.since_felt_s(p);
    }
}

}  // namespace

render::Image Still::draw(const Simulation& match, const HudSettings& settings, const Senses* senses) {
    auto& s = *state_;
    take_picture(match, s.picture);
    if (senses != nullptr) show(*senses, s.picture);
    s.renderer->draw(make_frame(s.arena_scene, s.picture, settings, s.context.size(), s.memory));
    return s.renderer->read_pixels();
}

Expected<void> Still::save(const Simulation& match, const HudSettings& settings,
                           const std::filesystem::path& file, const Senses* senses) {
    return render::write_png(file, draw(match, settings, senses));
}

}  // namespace thaum::game::inline hud
