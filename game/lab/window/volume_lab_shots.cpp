// Pictures of a volume in the lab, drawn without a window.
#include "game/data/match_data.h"
#include "game/lab/window/volume_lab.h"

namespace thaum::game::inline lab {

struct VolumeShots::State {
    render::Offscreen context;
    render::Renderer renderer;  // must be destroyed before its OpenGL context
    // The picture keeps a reference to the renderer, which therefore must not move in memory.
    std::optional<VolumePicture> picture;
    std::filesystem::path folder;
    Tick every;
};

VolumeShots::VolumeShots() = default;
VolumeShots::VolumeShots(VolumeShots&&) noexcept = default;
VolumeShots& VolumeShots::operator=(VolumeShots&&) noexcept = default;
VolumeShots::~VolumeShots() = default;

Expected<VolumeShots> VolumeShots::open(const VolumeLabPlan& plan) {
    VolumeShots shots;
    if (!plan.out.shots) return shots;
    if (auto made = make_lab_folder(plan.out, plan.out.every); !made) return made.error();
    auto context = render::Offscreen::create(plan.out.size.width, plan.out.size.height);
    if (!context) return context.error();
    context->make_current();
    auto renderer = render::Renderer::create(find_assets());
    if (!renderer) return renderer.error();
    shots.state_.reset(new State{std::move(*context), std::move(*renderer), std::nullopt, *plan.out.shots,
                                 static_cast<Tick>(plan.out.every)});
    shots.state_->picture.emplace(shots.state_->renderer, plan.lab);
    return shots;
}

Expected<void> VolumeShots::follow(const VolumeLab& lab, const VolumeView& view,
                                   const VolumeLabFigures& figures) {
    if (!state_ || lab.tick % state_->every != 0) return {};
    auto& s = *state_;
    VolumeView sharp = view;
    sharp.still = true;
    s.renderer.draw(s.picture->frame(lab, figures, sharp, s.context.size()));
    return write_lab_shot(s.folder, static_cast<std::int64_t>(lab.tick), s.renderer.read_pixels());
}

}  // namespace thaum::game::inline lab
