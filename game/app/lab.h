// game/app/lab.h: what `thaum lab --fluid` was asked for, and how it runs in a window.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "core/file_writer.h"
#include "game/lab/script.h"
#include "render/context.h"
#include "render/image.h"

namespace thaum::app {

/// A session that begins: a new one or a loaded one, with what the command line changed.
struct LabPlan {
    game::LabState lab;
    game::LabScript script{};
    std::optional<double> seconds{};  ///< of the session's own time; none: until the window is closed
    std::optional<std::filesystem::path> save{}, trace{}, shots{};
    std::int64_t every = 25;  ///< steps from picture to picture
    render::Size size{1280, 720};
    bool times = false;  ///< in the trace
    unsigned threads = 1;
};

/// Rows of the trace, if one was asked for.
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

/// Pictures without a window, if any were asked for: FOLDER/lab_STEP.png.
class LabShots {
public:
    /// The error is one line: the folder cannot be made, or there is no OpenGL.
    static Expected<LabShots> open(const LabPlan& plan);
    LabShots(LabShots&&) noexcept;
    LabShots& operator=(LabShots&&) noexcept;
    ~LabShots();

    /// Takes one where it is due after this step.
    Expected<void> follow(const game::LabState& lab, const game::LabFigures& figures);

private:
    struct State;
    LabShots();
    std::unique_ptr<State> state_;  ///< null: none are asked for
    std::filesystem::path folder_;
    std::int64_t every_ = 1;
};

/// The folder for pictures, where some were asked for.
Expected<void> make_lab_folder(const LabPlan& plan);
Expected<void> write_lab_shot(const std::filesystem::path& folder, std::int64_t step,
                              const render::Image& image);

/// Until the window is closed. The exit code.
int run_lab_window(LabPlan plan);

}  // namespace thaum::app
