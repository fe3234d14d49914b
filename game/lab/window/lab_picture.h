// game/lab/window/lab_picture.h: one picture of the lab: the cauldron with its brew and ladle, numbers about
// the flow, and the list of keys. The window and the saved pictures share this code.
#pragma once
#include "game/lab/controls.h"
#include "game/scene/brew_look.h"
#include "render/context.h"
#include "render/renderer.h"

namespace thaum::game::inline lab {

/// Camera that orbits the middle of the brew's surface and looks at it.
struct LabEye {
    double yaw = 0.5;     ///< angle about the vertical axis, from south towards east (rad)
    double pitch = 0.75;  ///< angle above the level surface (rad)
    double away = 4.2;    ///< distance from the middle of the surface (m)
};

/// Returns the camera after a rotation by yaw and pitch (rad) and with its distance multiplied by
/// `away_times`. It is limited to views that show the brew.
LabEye turned(const LabEye& eye, double yaw, double pitch, double away_times);
render::Camera camera_of(const LabEye& eye);

/// Contents of the screen besides the brew: keys, numbers about the flow, messages.
struct LabPage {
    LabHands hands{};
    LabEye eye{};
    std::string note{};     ///< message about the last action
    double steps_per_s{};   ///< steps computed per second of wall-clock time; 0: not shown
    double text_scale = 1;  ///< text scale from the settings
    bool panels = true;     ///< true: the panels with keys and numbers are shown
};

class LabPicture {
public:
    /// The renderer's OpenGL context must be current during the whole lifetime of the picture. The bowl is
    /// that of `lab` at this call.
    LabPicture(render::Renderer& renderer, const LabState& lab);

    /// Builds the frame. The reference stays valid until the next call.
    const render::Frame& frame(const LabState& lab, const LabFigures& figures, const LabPage& page,
                               render::Size size);

private:
    CauldronRules rules_;  ///< rules with the session's substances as ingredients
    render::MeshId vessel_{}, floor_{};
    BrewLook look_;
    BrewPicture picture_;
    std::int64_t shown_ = -1;  ///< number of the step that `picture_` shows
    std::vector<render::Instance> instances_;
    std::vector<render::PointLight> lights_;
    render::Frame frame_;
};

/// Adds the panels: keys on the left, numbers about the flow on the right.
void add_lab_words(render::Overlay& out, const LabState& lab, const LabFigures& figures, const LabPage& page,
                   render::Size size);

}  // namespace thaum::game::inline lab
