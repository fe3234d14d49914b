#include "render/detail/program.h"

#include <algorithm>

#include "core/file.h"
#include "core/text.h"

namespace thaum::render::detail {
namespace {

constexpr std::size_t max_shader = 1U << 20U;  // largest shader file (bytes)

std::string first_line(const std::string& log) {
    const auto from = log.find_first_not_of(" \n\r\t");
    if (from == std::string::npos) return "the driver does not say why";
    return log.substr(from, log.find_first_of("\n\r", from) - from);
}

template <class Length, class Read>
std::string log_of(GLuint name, Length length_of, Read read) {
    GLint length = 0;
    length_of(name, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
    GLsizei written = 0;
    read(name, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return first_line(log);
}

/// Inserts a definition of each name of the variant after the first line, which must be #version. Line
/// numbers in error messages stay the same.
std::string with_variant(const std::string& source, const std::vector<std::string_view>& variant) {
    const auto first_end = std::min(source.find('\n'), source.size() - 1) + 1;
    std::string out = source.substr(0, first_end);
    for (const auto& name : variant) out += text("#define ", name, "\n");
    return text(out, "#line 2\n", source.substr(first_end));
}

Expected<Shader> compile(const std::filesystem::path& file, GLenum stage,
                         const std::vector<std::string_view>& variant) {
    auto source = read_text_file(file, max_shader);
    if (!source) return source.error();
    if (!variant.empty() && !source->empty()) source = with_variant(*source, variant);
    Shader shader(glCreateShader(stage));
    const char* start = source->data();
    const auto length = static_cast<GLint>(source->size());
    glShaderSource(shader.get(), 1, &start, &length);
    glCompileShader(shader.get());
    GLint good = GL_FALSE;
    glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &good);
    if (good != GL_TRUE) {
        return fail(text(file.string(), ": ", log_of(shader.get(), glGetShaderiv, glGetShaderInfoLog)));
    }
    return shader;
}

}  // namespace

Expected<Program> load_program(const std::vector<std::filesystem::path>& files,
                               const std::vector<std::string_view>& variant) {
    Program program(glCreateProgram());
    std::vector<Shader> shaders;
    GLenum stage = GL_VERTEX_SHADER;
    for (const auto& file : files) {
        if (file.extension() != ".glsl")
            stage = file.extension() == ".vert" ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER;
        auto shader = compile(file, stage, variant);
        if (!shader) return shader.error();
        glAttachShader(program.get(), shader->get());
        shaders.push_back(std::move(*shader));
    }
    glLinkProgram(program.get());
    GLint good = GL_FALSE;
    glGetProgramiv(program.get(), GL_LINK_STATUS, &good);
    if (good != GL_TRUE) {
        return fail(text(files.front().string(),
                         ": does not link: ", log_of(program.get(), glGetProgramiv, glGetProgramInfoLog)));
    }
    for (const auto& shader : shaders) glDetachShader(program.get(), shader.get());
    return program;
}

GLint uniform(const Program& program, const char* name) { return glGetUniformLocation(program.get(), name); }

}  // namespace thaum::render::detail
