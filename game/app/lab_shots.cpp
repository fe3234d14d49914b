// Pictures of the lab, drawn without a window.
#include "core/file.h"
#include "core/text.h"
#include "game/app/lab.h"
#include "game/app/lab_picture.h"
#include "game/data/match_data.h"

namespace thaum::app {

struct LabShots::State {
    render::Offscreen context;
    render::Renderer renderer;  // destroyed before its context
    LabPicture picture;
    LabPage page{};
};

LabShots::LabShots() = default;
LabShots::LabShots(LabShots&&) noexcept = default;
LabShots& LabShots::operator=(LabShots&&) noexcept = default;
LabShots::~LabShots() = default;

namespace {

std::filesystem::path lab_shot(const std::filesystem::path& folder, std::int64_t step) {
    const auto digits = text(step);
    const auto zeros = std::string(digits.size() < 7 ? 7 - digits.size() : 0, '0');
    return folder / text("lab_", zeros, digits, ".png");
}

}  // namespace

Expected<void> make_lab_folder(const LabPlan& plan) {
    if (!plan.shots) return {};
    if (auto made = make_folder(*plan.shots); !made) return made;
    return check_output(lab_shot(*plan.shots, plan.lab.steps + plan.every));
}

Expected<void> write_lab_shot(const std::filesystem::path& folder, std::int64_t step,
                              const render::Image& image) {
    return render::write_png(lab_shot(folder, step), image);
}

Expected<LabShots> LabShots::open(const LabPlan& plan) {
    LabShots shots;
    if (!plan.shots) return shots;
    if (auto made = make_lab_folder(plan); !made) return tl::unexpected(made.error());
    auto context = render::Offscreen::create(plan.size.width, plan.size.height);
    if (!context) return tl::unexpected(context.error());
    context->make_current();
    auto renderer = render::Renderer::create(game::find_assets());
    if (!renderer) return tl::unexpected(renderer.error());
    LabPicture picture(*renderer, plan.lab);
    shots.folder_ = *plan.shots;
    shots.every_ = plan.every;
    shots.state_.reset(new State{std::move(*context), std::move(*renderer), std::move(picture)});
    shots.state_->page.panels = false;
    return shots;
}

Expected<void> LabShots::follow(const game::LabState& lab, const game::LabFigures& figures) {
    if (!state_ || lab.steps % every_ != 0) return {};
    auto& s = *state_;
    s.renderer.draw(s.picture.frame(lab, figures, s.page, s.context.size()));
    return write_lab_shot(folder_, lab.steps, s.renderer.read_pixels());
}

}  // namespace thaum::app
