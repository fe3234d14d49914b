#include "game/lab/window/volume_lab_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/file.h"
#include "core/text.h"
#include "core/write_rule.h"
#include "field/volume.h"
#include "game/lab/saved_body.h"

namespace thaum::game::inline lab {
namespace {

/// Files of colours and materials beside that of the first volume; none for a generated volume.
std::vector<std::filesystem::path> companions(const VolumeLabPlan& plan) {
    if (is_made(plan.first.volume)) return {};
    const auto files = companions_of(plan.first.volume);
    return {files.begin(), files.end()};
}

struct OutputFile {
    std::string_view option;
    std::filesystem::path path;
};

std::vector<OutputFile> outputs_of(const LabOutputs& out) {
    std::vector<OutputFile> files;
    if (out.save) {
        files.push_back({"--save", *out.save});
        for (const auto& file : companions_of(*out.save)) files.push_back({"--save", file});
    }
    if (out.trace) files.push_back({"--trace", *out.trace});
    return files;
}

}  // namespace

bool is_made(std::string_view name) {
    const auto made = field::volume_names();
    return std::ranges::find(made, name) != made.end();
}

void protect_companions(const VolumeLabPlan& plan) {
    for (const auto& file : companions(plan)) protect_input(file);
}

Expected<void> check_outputs(const VolumeLabPlan& plan) {
    const auto files = outputs_of(plan.out);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto& file = files[i].path;
        for (const auto& read : companions(plan))
            if (same_target(file, read))
                return fail(text(file.string(), ": cannot write: it is read by this command, beside ",
                                 plan.first.volume, "; give another name"));
        for (std::size_t other = 0; other < i; ++other)
            if (same_target(file, files[other].path))
                return fail(text(files[other].option, " and ", files[i].option, " both write ", file.string(),
                                 "; give one of them another name"));
        if (auto free = check_output(file); !free) return free;
    }
    return {};
}

}  // namespace thaum::game::inline lab
