// game/lab/window/volume_lab_picture.h: one picture of a volume in the lab: the body or the flow, the tip of
// the device, its proxy (the point that modes and walls hold or lead), and the force.
#pragma once
#include <memory>
#include <vector>

#include "field/transfer.h"
#include "game/lab/volume_lab.h"
#include "render/context.h"
#include "render/renderer.h"
#include "render/ribbons.h"

namespace thaum::game::inline lab {

/// Camera that orbits a place near the middle of the workspace.
struct VolumeEye {
    double yaw = 0.5;    ///< angle about the upright axis (rad)
    double pitch = 0.4;  ///< angle above the horizontal (rad)
    double away = 1.6;   ///< distance of the camera from `aim`, in lengths of the volume's diagonal
    vec3 aim{};          ///< point shown in the middle of the picture (m)
};

/// How the volume is shown.
struct VolumeView {
    render::ScanLook look = render::ScanLook::surface;
    double level{};  ///< value (density) at which the surface is drawn
    /// Opacity as a function of the value, 0 to 1, for the translucent look.
    field::TransferFunction opacity{};
    /// number of stream ribbons of a flow, besides the one through the proxy (the point that is felt)
    int ribbons = 40;
    /// true: the picture is drawn quickly, because the hand, the view or the body moved a short time ago
    bool moving = false;
    bool still = false;  ///< true: the picture is drawn sharply, however long that takes
    VolumeEye eye{};
};

/// A suitable view of a volume, seen from near: the surface between a body and its surroundings, or a thin
/// haze for a flow.
VolumeView usual_view(const VolumeLab& lab);

/// Centres the picture on the visible part of the volume, at a distance where it fills 70 % of the height.
void come_near(const VolumeLab& lab, VolumeView& view);

class VolumePicture {
public:
    /// The renderer's OpenGL context must be current during the whole lifetime of the picture.
    VolumePicture(render::Renderer& renderer, const VolumeLab& lab);

    /// Builds the frame. The reference is valid until the next call, and no longer than the lab's body.
    const render::Frame& frame(const VolumeLab& lab, const VolumeLabFigures& figures, const VolumeView& view,
                               render::Size size);

private:
    /// A volume in the form in which it is drawn.
    struct Drawn {
        render::ScanId scan{};
        render::Ribbons ribbons{};
        render::ScanTable table{};
        std::vector<float> lengths{};  ///< lengths of the vectors, for a flow
    };

    void add_ribbons(const VolumeRef& volume, Drawn& drawn, vec3 proxy, int count);
    void add_scan(const VolumeRef& volume, Drawn& drawn, const VolumeView& view);

    render::Renderer* renderer_;
    std::vector<std::unique_ptr<Drawn>> drawn_;  ///< for each volume, the form in which it is drawn
    render::SpeedColours colours_{};
    std::vector<vec3> seeds_;
    render::MeshId tip_{}, proxy_{}, rod_{}, edge_{};
    std::vector<render::ScanMaterial> materials_;
    std::vector<render::Instance> instances_;
    std::vector<render::Scan> scans_;
    render::Frame frame_;
};

render::Camera camera_of(const VolumeEye& eye, const VolumeLab& lab);

}  // namespace thaum::game::inline lab
