// game/lab/window/lab_outputs.h: outputs that both labs write: a state at the end, a trace, and pictures.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "core/file_writer.h"
#include "game/command_line/arguments.h"
#include "render/image.h"

namespace thaum::game::inline lab {

/// Outputs of a session, as the options --save, --trace, --shots, --every and --size ask for them.
struct LabOutputs {
    std::optional<std::filesystem::path> save{}, trace{}, shots{};
    std::int64_t every{};  ///< number of steps between two pictures
    render::Size size{1280, 720};
};

/// Reads the options about outputs. `every`: interval between pictures if --every is not given (steps). The
/// error names the unsuitable option.
Expected<LabOutputs> read_lab_outputs(const Arguments& arguments, std::int64_t every);

/// A CSV file that is written row by row. Nothing is written if no file is named.
class LabTrace {
public:
    static Expected<LabTrace> open(const std::optional<std::filesystem::path>& file, std::string_view header);
    /// Writes the rows that append(rows) adds to a string. Without a file, `append` is not called.
    template <class Append>
    void add(Append append) {
        if (!file_) return;
        rows_.clear();
        append(rows_);
        file_->write(rows_);
    }
    Expected<void> close();

private:
    std::optional<FileWriter> file_;
    std::string rows_;
};

/// Makes the folder for pictures if one is named. `first` is the step of the first picture.
Expected<void> make_lab_folder(const LabOutputs& outputs, std::int64_t first);
/// Writes FOLDER/lab_STEP.png.
Expected<void> write_lab_shot(const std::filesystem::path& folder, std::int64_t step,
                              const render::Image& image);

}  // namespace thaum::game::inline lab
