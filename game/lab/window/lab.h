// game/lab/window/lab.h: the options of `thaum lab --fluid`, its pictures, and its window.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "game/lab/script.h"
#include "game/lab/window/lab_outputs.h"
#include "render/context.h"
#include "render/image.h"

namespace thaum::game::inline lab {

/// Options of one session of the fluid lab: a new or loaded state, with the changes from the command line.
struct LabPlan {
    LabState lab;
    LabScript script{};
    /// length of the session in simulated time (s); std::nullopt: until the window is closed
    std::optional<double> seconds{};
    LabOutputs out{};
    bool times = false;  ///< true: the trace, the table of all steps, has columns with computing times
    unsigned threads = 1;
};

/// Pictures drawn without a window, saved as FOLDER/lab_STEP.png; none if the plan names no folder.
class LabShots {
public:
    /// Prepares the pictures. The error is one line: the folder cannot be made, or there is no OpenGL.
    static Expected<LabShots> open(const LabPlan& plan);
    LabShots(LabShots&&) noexcept;
    LabShots& operator=(LabShots&&) noexcept;
    ~LabShots();

    /// Saves a picture if one is due after this step.
    Expected<void> follow(const LabState& lab, const LabFigures& figures);

private:
    struct State;
    LabShots();
    std::unique_ptr<State> state_;  ///< null if no pictures are wanted
    std::filesystem::path folder_;
    std::int64_t every_ = 1;
};

/// Runs the command `thaum lab`. It prints its help itself.
int run_lab(const std::vector<std::string>& words);

/// Runs the lab in a window until that is closed. Returns an exit code.
int run_lab_window(LabPlan plan);

}  // namespace thaum::game::inline lab
