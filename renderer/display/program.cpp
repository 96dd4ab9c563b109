#include "display/program.h"

#include <glm/gtc/type_ptr.hpp>

#include "base/error.h"
#include "base/log.h"
#include "display/shader_source.h"

namespace brewster {
namespace {

std::string shader_log(GLuint shader) {
    GLint length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
    return log;
}

std::string program_log(GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
    return log;
}

/// Attaches the compiled shader; GL frees it with the program.
void attach(GLuint program, GLenum stage, const std::string& name, const std::vector<std::string>& defines) {
    const ShaderSource source = shader_source(name, defines);
    const GLuint shader = glCreateShader(stage);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    std::string log = shader_log(shader);
    if (log.empty() && compiled) return;
    for (std::size_t i = 0; i < source.files.size(); ++i) log += "\n  " + std::to_string(i) + " = " + source.files[i];
    if (!compiled) throw Error("does not compile:\n" + log, name, "mend the shader or leave --shader-dir out");
    log_warning(name + ": " + log);
}

}  // namespace

Program::Program(const std::string& vertex, const std::string& fragment, const std::vector<std::string>& defines)
    : name_(vertex + " + " + fragment), object_(ProgramObject::create()) {
    attach(object_.id(), GL_VERTEX_SHADER, vertex, defines);
    attach(object_.id(), GL_FRAGMENT_SHADER, fragment, defines);
    glLinkProgram(object_.id());
    GLint linked = 0;
    glGetProgramiv(object_.id(), GL_LINK_STATUS, &linked);
    const std::string log = program_log(object_.id());
    if (!linked) throw Error("do not link:\n" + log, name_, "mend the shaders or leave --shader-dir out");
    if (!log.empty()) log_warning(name_ + ": " + log);

    GLint count = 0;
    glGetProgramiv(object_.id(), GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        char uniform[128];
        GLint size = 0;
        GLenum type = 0;
        glGetActiveUniform(object_.id(), static_cast<GLuint>(i), sizeof uniform, nullptr, &size, &type, uniform);
        uniforms_[uniform] = glGetUniformLocation(object_.id(), uniform);
    }
}

GLint Program::location(const std::string& uniform) const {
    const auto found = uniforms_.find(uniform);
    if (found == uniforms_.end()) throw Error("has no uniform " + uniform, name_, "use it in the shader");
    return found->second;
}

void Program::set(const std::string& uniform, int value) const {
    use();
    glUniform1i(location(uniform), value);
}

void Program::set(const std::string& uniform, float value) const {
    use();
    glUniform1f(location(uniform), value);
}

void Program::set(const std::string& uniform, glm::vec2 value) const {
    use();
    glUniform2f(location(uniform), value.x, value.y);
}

void Program::set(const std::string& uniform, glm::uvec2 value) const {
    use();
    glUniform2ui(location(uniform), value.x, value.y);
}

void Program::set(const std::string& uniform, const glm::vec3& value) const {
    use();
    glUniform3f(location(uniform), value.x, value.y, value.z);
}

void Program::set(const std::string& uniform, const glm::vec4& value) const {
    use();
    glUniform4f(location(uniform), value.x, value.y, value.z, value.w);
}

void Program::set(const std::string& uniform, const glm::mat4& value) const {
    use();
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace brewster
