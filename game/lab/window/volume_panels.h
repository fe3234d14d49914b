// game/lab/window/volume_panels.h: the panels of the volume lab: choice of the volume, modes with transfer
// functions that are drawn freehand, look, tools, device, and the force over time.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "game/lab/window/volume_lab.h"

namespace thaum::game::inline lab {

/// Question about a carved body that is not saved.
struct UnsavedQuestion {
    enum class Before : std::uint8_t { nothing, leaving, opening };
    enum class Answer : std::uint8_t { save, drop, stay };
    Before before{};  ///< action that waits for the answer to the question
    bool shown = false;
    std::optional<Answer> answer{};  ///< answer given in the last picture
};

/// A volume to open.
struct NextVolume {
    std::string name{};       ///< name as on the command line
    std::int64_t moment = 1;  ///< number of the time step, from 1, if the file has several
};

/// Settings that a person has made in the panels, and requests for actions.
struct VolumePanelState {
    std::vector<LabMode> modes{};    ///< chosen haptic modes
    std::vector<FeelPart> feel{};    ///< chosen parts of the force law by which the body is felt
    std::vector<LabPlace> places{};  ///< placements of all volumes
    /// Changed settings (modes, feel, places) for the next step.
    std::optional<VolumeLabSettings> change{};
    bool one_level = true;  ///< true: the surface is drawn at the density at which it is felt
    std::size_t tool{};     ///< index into VolumeLab::data.tools
    std::string device{};   ///< device model of the arm that the panel shows
    std::optional<std::string> next_device{};  ///< device model that was chosen to replace the present one
    std::optional<NextVolume> open{};          ///< volume to be opened
    std::optional<int> moment{};               ///< time step to which the slider is being dragged
    bool saves = false, saves_session = false;
    bool hand_held = false;  ///< true: the hand stays where it is, whatever the mouse does
    UnsavedQuestion question{};
    int history = 0;               ///< step in the history of changes: -1 undo, 1 redo, 0 neither
    std::string note{};            ///< message about the last action
    std::array<char, 256> path{};  ///< text of the field for a file path

    std::array<float, 2000> force{};  ///< ring buffer of the force in the last ticks (N)
    std::size_t newest{};
};

/// Index of the tool that is selected first: one that removes material, so that the first try has a visible
/// effect.
std::size_t usual_tool(const VolumeLab& lab);

/// Whether the surface is drawn at the density at which the chosen modes let it be felt.
bool levels_agree(const VolumeView& view, VolumePanelState& state);

/// Adds the force of a tick to the plot.
void add_force(VolumePanelState& state, double newtons);

/// Shows all panels and stores the user's changes in them.
void show_panels(VolumeLabPlan& plan, const VolumeLabFigures& figures, VolumePanelState& state);

}  // namespace thaum::game::inline lab
