// game/lab/window/volume_lab.h: the options of `thaum lab VOLUME`, its pictures, and its window.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "game/lab/hand_path.h"
#include "game/lab/volume_lab.h"
#include "game/lab/volume_session.h"
#include "game/lab/window/lab_outputs.h"
#include "game/lab/window/volume_lab_picture.h"
#include "render/context.h"

namespace thaum::game::inline lab {

/// A period of a session in which a tool is held.
struct PlannedCarve {
    std::size_t tool{};   ///< index into VolumeLab::data.tools
    double from{}, to{};  ///< times at which the tool is taken up and put down (s)
};

/// Options of one session of the volume lab.
struct VolumeLabPlan {
    SessionVolume first{};                ///< the volume that can be carved
    std::vector<SessionVolume> beside{};  ///< the added volumes
    bool registered{};  ///< true: the added volumes are placed relative to the first one as their files say
    std::string device{};  ///< model of the simulated arm
    VolumeLab lab{};
    HandPath path{};
    /// true: the mouse moves the hand from the start; false: the path moves the hand until the mouse does
    bool by_mouse{};
    std::vector<PlannedCarve> carves{};
    VolumeView view{};
    /// Length of the session in simulated time (s); std::nullopt: until the window is closed.
    std::optional<double> seconds{};
    std::optional<std::filesystem::path> session_file{};  ///< file of the session's settings
    LabOutputs out{};
    std::vector<std::string> notes{};  ///< messages about the volumes for the user, one line each
};

/// Opens the volumes of a session and applies its settings. The error says what is wrong with a file or a
/// setting.
Expected<VolumeLabPlan> plan_of(const VolumeSession& session);
/// The settings of a session that would open the plan's volumes as they are now, at their present places.
VolumeSession session_of(const VolumeLabPlan& plan);

/// Input of the next step, from the plan's path and periods of carving.
VolumeLabInput planned_input(const VolumeLabPlan& plan);

/// Pictures drawn without a window, saved as FOLDER/lab_TICK.png; none if the plan names no folder.
class VolumeShots {
public:
    /// Prepares the pictures. The error is one line: the folder cannot be made, or there is no OpenGL.
    static Expected<VolumeShots> open(const VolumeLabPlan& plan);
    VolumeShots(VolumeShots&&) noexcept;
    VolumeShots& operator=(VolumeShots&&) noexcept;
    ~VolumeShots();

    /// Saves a picture if one is due after this step.
    Expected<void> follow(const VolumeLab& lab, const VolumeView& view, const VolumeLabFigures& figures);

private:
    struct State;
    VolumeShots();
    std::unique_ptr<State> state_;  ///< null if no pictures are wanted
};

/// Runs `thaum lab VOLUME ...` with these arguments. Returns an exit code.
int run_volume_lab(const std::vector<std::string>& words);
std::string_view volume_lab_help();

/// Runs the lab in a window until that is closed. Returns an exit code.
int run_volume_window(VolumeLabPlan plan);

}  // namespace thaum::game::inline lab
