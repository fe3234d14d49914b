// game/app/lab_picture.h: the lab as a picture: the cauldron with its brew and ladle, the figures, the list of keys. The same in the
// window and in files.
#pragma once
#include "game/hud/brew_look.h"
#include "game/lab/controls.h"
#include "render/context.h"
#include "render/renderer.h"

namespace thaum::app {

/// An eye that goes round the middle of the brew's surface.
struct LabEye {
    double yaw = 0.5;     ///< rad, from the south to the east
    double pitch = 0.75;  ///< rad, above the level
    double away = 4.2;    ///< m
};

/// Within what can be seen.
LabEye turned(const LabEye& eye, double yaw, double pitch, double away_times);
render::Camera camera_of(const LabEye& eye);

/// What is shown besides the brew.
struct LabPage {
    game::LabHands hands{};
    LabEye eye{};
    std::string note{};     ///< what just happened
    double steps_per_s{};   ///< of the clock; 0: not told
    double text_scale = 1;  ///< of the settings
    bool panels = true;     ///< keys and figures are shown
};

class LabPicture {
public:
    /// The renderer's context must be current, and stay so; the bowl is that of the session now.
    LabPicture(render::Renderer& renderer, const game::LabState& lab);

    /// What the last call gave is gone then.
    const render::Frame& frame(const game::LabState& lab, const game::LabFigures& figures,
                               const LabPage& page, render::Size size);

private:
    game::CauldronRules rules_;  ///< with the session's substances as ingredients
    render::MeshId vessel_{}, floor_{};
    game::BrewLook look_;
    game::BrewPicture picture_;
    std::int64_t shown_ = -1;  ///< step
    std::vector<render::Instance> instances_;
    std::vector<render::PointLight> lights_;
    render::Frame frame_;
};

/// The words on the left and on the right.
void add_lab_words(render::Overlay& out, const game::LabState& lab, const game::LabFigures& figures,
                   const LabPage& page, render::Size size);

}  // namespace thaum::app
