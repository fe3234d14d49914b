// game/lab/window/volume_panels.h: the panels of the volume lab: which volume, modes with transfer functions drawn freehand,
// look, tools, device, and the force over time.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "game/lab/window/volume_lab.h"

namespace thaum::app {

/// Question about a carved body that is not saved.
struct UnsavedQuestion {
    enum class Before : std::uint8_t { nothing, leaving, opening };
    enum class Answer : std::uint8_t { save, drop, stay };
    Before before{};  ///< action that waits for the answer
    bool shown = false;
    std::optional<Answer> answer{};  ///< given in the last picture
};

/// A volume to open.
struct NextVolume {
    std::string name{};       ///< as on the command line
    std::int64_t moment = 1;  ///< number of the moment, from 1, if the file has time
};

/// What a person has set in the panels, and what they ask for.
struct VolumePanelState {
    std::vector<game::LabMode> modes{};               ///< chosen modes
    std::vector<game::FeelPart> feel{};               ///< chosen parts of the body's feel
    std::vector<game::LabPlace> places{};             ///< places of all volumes
    std::optional<game::VolumeLabSettings> change{};  ///< both, for the next step
    bool one_level = true;                            ///< the drawn level is the felt one
    std::size_t tool{};                               ///< index into VolumeLab::data.tools
    std::string device{};                             ///< model of the arm that is shown
    std::optional<std::string> next_device{};         ///< model that was chosen in place of it
    std::optional<NextVolume> open{};                 ///< volume to open
    std::optional<int> moment{};                      ///< moment to which the slider is being pulled
    bool saves = false, saves_session = false;
    bool hand_held = false;  ///< the hand stays where it is, whatever the mouse does
    UnsavedQuestion question{};
    int history = 0;               ///< -1: undo, 1: redo
    std::string note{};            ///< message about the last action
    std::array<char, 256> path{};  ///< text of the field for a file's path

    std::array<float, 2000> force{};  ///< force in the last ticks (N), a ring
    std::size_t newest{};
};

/// Index of the tool that a person has first: one that takes material away, so that a first try shows something.
std::size_t usual_tool(const game::VolumeLab& lab);

/// Whether the surface is drawn where the chosen modes let it be felt.
bool levels_agree(const VolumeView& view, VolumePanelState& state);

/// Adds the force of a tick to the plot.
void add_force(VolumePanelState& state, double newtons);

/// Shows all panels and takes what is done on them.
void show_panels(VolumeLabPlan& plan, const game::VolumeLabFigures& figures, VolumePanelState& state);

}  // namespace thaum::app
