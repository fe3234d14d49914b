// Pictures of the lab, drawn without a window.
#include "core/file.h"
#include "core/text.h"
#include "game/data/match_data.h"
#include "game/lab/window/lab.h"
#include "game/lab/window/lab_picture.h"

namespace thaum::game::inline lab {

struct LabShots::State {
    render::Offscreen context;
    render::Renderer renderer;  // must be destroyed before its OpenGL context
    LabPicture picture;
    LabPage page{};
};

LabShots::LabShots() = default;
LabShots::LabShots(LabShots&&) noexcept = default;
LabShots& LabShots::operator=(LabShots&&) noexcept = default;
LabShots::~LabShots() = default;

Expected<LabShots> LabShots::open(const LabPlan& plan) {
    LabShots shots;
    if (!plan.out.shots) return shots;
    if (auto made = make_lab_folder(plan.out, plan.lab.steps + plan.out.every); !made) return made.error();
    auto context = render::Offscreen::create(plan.out.size.width, plan.out.size.height);
    if (!context) return context.error();
    context->make_current();
    auto renderer = render::Renderer::create(find_assets());
    if (!renderer) return renderer.error();
    LabPicture picture(*renderer, plan.lab);
    shots.folder_ = *plan.out.shots;
    shots.every_ = plan.out.every;
    shots.state_.reset(new State{std::move(*context), std::move(*renderer), std::move(picture)});
    shots.state_->page.panels = false;
    return shots;
}

Expected<void> LabShots::follow(const LabState& lab, const LabFigures& figures) {
    if (!state_ || lab.steps % every_ != 0) return {};
    auto& s = *state_;
    s.renderer.draw(s.picture.frame(lab, figures, s.page, s.context.size()));
    return write_lab_shot(folder_, lab.steps, s.renderer.read_pixels());
}

}  // namespace thaum::game::inline lab
