#include "game/lab/window/lab_picture.h"

#include <algorithm>
#include <cmath>

#include "game/scene/furniture.h"
#include "render/colour.h"

namespace thaum::game::inline lab {
namespace {

constexpr double min_pitch = -0.1, max_pitch = 1.5, min_away = 1.5, max_away = 12;
constexpr double eye_middle = -0.25;  // height of the camera's target above the level surface (m)
constexpr double handle = 1.3;        // length of the ladle's handle (m)
constexpr double hand_newtons = 3.3;  // peak force of the simulated device in a match (N)

/// Picture of the ladle; its handle leans away from the middle of the bowl.
LadlePicture ladle_picture(const LabState& lab, double newtons) {
    const vec3 at = *lab.ladle;
    const vec3 out =
        glm::length(at) > 1e-6 ? glm::normalize(vec3(at.x, 0, at.z) + vec3(1e-6, 0, 0)) : vec3(1, 0, 0);
    return {.bowl = at,
            .top = at + handle * glm::normalize(0.45 * out + vec3(0, 1, 0)),
            .force_share = newtons * lab.rules.ladle.newtons_per_newton / hand_newtons};
}

fmat4 at_height(double y) {
    fmat4 model(1);
    model[3].y = static_cast<float>(y);
    return model;
}

}  // namespace

LabEye turned(const LabEye& eye, double yaw, double pitch, double away_times) {
    return {.yaw = std::remainder(eye.yaw + yaw, 2 * pi),
            .pitch = std::clamp(eye.pitch + pitch, min_pitch, max_pitch),
            .away = std::clamp(eye.away * away_times, min_away, max_away)};
}

render::Camera camera_of(const LabEye& eye) {
    const quat turn = look_rotation(eye.yaw, -eye.pitch);
    render::Camera camera;
    camera.position = fvec3(turn * vec3(0, 0, eye.away) + vec3(0, eye_middle, 0));
    camera.orientation = fquat(turn);
    camera.fov_y = 0.9F;
    return camera;
}

LabPicture::LabPicture(render::Renderer& renderer, const LabState& lab)
    : rules_(lab.rules), look_(make_brew_look(renderer, {.middle = vec3(0), .basin = lab.basin})) {
    const auto& size = lab.settings.room.size;
    vessel_ = renderer.upload(cauldron(bowl(size)).lit);
    floor_ = renderer.upload(
        render::cylinder(static_cast<float>(4 * size.radius), 0.1F, 48, render::colour(0x4A4458)));
    frame_.bloom = false;
    frame_.quality = render::first_quality(renderer.device());
}

const render::Frame& LabPicture::frame(const LabState& lab, const LabFigures& figures, const LabPage& page,
                                       render::Size size) {
    if (lab.steps != shown_) {
        shown_ = lab.steps;
        rules_.ingredients = lab.settings.substances;
        take_brew(lab.brew, rules_, picture_.state + 1, picture_);
    }
    show_brew(picture_, {.arrows = page.hands.arrows, .streamlines = page.hands.streamlines}, look_);
    const auto& room = lab.settings.room;
    const double middle = -room.size.height * (room.filled - 0.5);  // height of the bowl's middle (m)
    instances_.clear();
    instances_.push_back({.mesh = vessel_, .model = at_height(middle)});
    instances_.push_back({.mesh = floor_, .model = at_height(middle - room.size.height / 2 - 0.05)});
    add_brew(look_, instances_);
    if (lab.ladle) add_ladle(look_.meshes, ladle_picture(lab, figures.ladle_n), instances_);
    lights_ = {{.position = {0, 1.2F, 0}, .colour = 2.5F * fvec3(lab.rules.colour), .radius = 5}};
    frame_.width = size.width;
    frame_.height = size.height;
    frame_.internal_scale = render::internal_scale_of(frame_.quality, size.height);
    frame_.views = {{.camera = camera_of(page.eye),
                     .viewport = {0, 0, size.width, size.height},
                     .instances = instances_,
                     .lights = lights_,
                     .environment = {},
                     .shades = {},
                     .blocks = {},
                     .volume = &look_.volume}};
    frame_.overlay.items.clear();
    add_lab_words(frame_.overlay, lab, figures, page, size);
    return frame_;
}

}  // namespace thaum::game::inline lab
