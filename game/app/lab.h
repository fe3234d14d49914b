// game/app/lab.h: the options of `thaum lab --fluid`, its trace and pictures, and its window.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "core/file_writer.h"
#include "game/lab/script.h"
#include "render/context.h"
#include "render/image.h"

namespace thaum::app {

/// Options of one lab session: a new or loaded state with the command line's changes.
struct LabPlan {
    game::LabState lab;
    game::LabScript script{};
    /// length of the session in simulated time (s); std::nullopt: until the window is closed
    std::optional<double> seconds{};
    std::optional<std::filesystem::path> save{}, trace{}, shots{};
    std::int64_t every = 25;  ///< number of steps between two pictures
    render::Size size{1280, 720};
    bool times = false;  ///< true: the trace has columns with computing times
    unsigned threads = 1;
};

/// Rows of the CSV trace; writes nothing if the plan names no trace.
class LabTrace {
public:
    static Expected<LabTrace> open(const LabPlan& plan);
    void add(const game::LabState& lab, const game::LabFigures& figures);
    Expected<void> close();

private:
    std::optional<FileWriter> file_;
    bool times_ = false;
    std::string rows_;
};

/// Pictures drawn without a window, saved as FOLDER/lab_STEP.png; none if the plan names no folder.
class LabShots {
public:
    /// The error is one line: the folder cannot be made, or there is no OpenGL.
    static Expected<LabShots> open(const LabPlan& plan);
    LabShots(LabShots&&) noexcept;
    LabShots& operator=(LabShots&&) noexcept;
    ~LabShots();

    /// Saves a picture if one is due after this step.
    Expected<void> follow(const game::LabState& lab, const game::LabFigures& figures);

private:
    struct State;
    LabShots();
    std::unique_ptr<State> state_;  ///< null: no pictures are wanted
    std::filesystem::path folder_;
    std::int64_t every_ = 1;
};

/// Makes the folder for pictures if the plan names one.
Expected<void> make_lab_folder(const LabPlan& plan);
Expected<void> write_lab_shot(const std::filesystem::path& folder, std::int64_t step,
                              const render::Image& image);

/// Runs the lab in a window until the window is closed. Returns an exit code.
int run_lab_window(LabPlan plan);

}  // namespace thaum::app
