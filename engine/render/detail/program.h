// Loads shader programs from files.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "render/detail/gl.h"

namespace thaum::render::detail {

/// Compiles and links files. The file extension selects the stage: .vert, .frag; a .glsl file belongs to the
/// stage of the file before it. Each name in `variant` is defined in all files. The error names the file and
/// the first line of the driver's log.
Expected<Program> load_program(const std::vector<std::filesystem::path>& files,
                               const std::vector<std::string_view>& variant = {});

/// Location of a uniform. Returns -1, which OpenGL ignores, if the driver found the uniform unused.
GLint uniform(const Program& program, const char* name);

}  // namespace thaum::render::detail
