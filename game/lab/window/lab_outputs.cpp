#include "game/lab/window/lab_outputs.h"

#include "core/file.h"
#include "core/text.h"

namespace thaum::game::inline lab {
namespace {

std::filesystem::path lab_shot(const std::filesystem::path& folder, std::int64_t step) {
    const auto digits = text(step);
    const auto zeros = std::string(digits.size() < 7 ? 7 - digits.size() : 0, '0');
    return folder / text("lab_", zeros, digits, ".png");
}

}  // namespace

Expected<LabOutputs> read_lab_outputs(const Arguments& arguments, std::int64_t every) {
    LabOutputs outputs{.save = arguments.path("--save"),
                       .trace = arguments.path("--trace"),
                       .shots = arguments.path("--shots")};
    if (arguments.has("--every") && !outputs.shots) return fail("--every needs --shots");
    if (arguments.has("--size") && arguments.has("--headless") && !outputs.shots)
        return fail("--size needs --shots, or a window");
    const auto wanted = arguments.whole("--every", 1, 1'000'000, static_cast<std::uint64_t>(every));
    if (!wanted) return wanted.error();
    outputs.every = static_cast<std::int64_t>(*wanted);
    if (const auto word = arguments.value("--size")) {
        const auto size = parse_size(*word, "--size");
        if (!size) return size.error();
        outputs.size = *size;
    }
    return outputs;
}

Expected<LabTrace> LabTrace::open(const std::optional<std::filesystem::path>& file, std::string_view header) {
    LabTrace trace;
    if (!file) return trace;
    auto writer = FileWriter::create(*file);
    if (!writer) return writer.error();
    trace.file_.emplace(std::move(*writer));
    trace.file_->write(header);
    return trace;
}

Expected<void> LabTrace::close() { return file_ ? file_->close() : Expected<void>(); }

Expected<void> make_lab_folder(const LabOutputs& outputs, std::int64_t first) {
    if (!outputs.shots) return {};
    if (auto made = make_folder(*outputs.shots); !made) return made;
    return check_output(lab_shot(*outputs.shots, first));
}

Expected<void> write_lab_shot(const std::filesystem::path& folder, std::int64_t step,
                              const render::Image& image) {
    return render::write_png(lab_shot(folder, step), image);
}

}  // namespace thaum::game::inline lab
