#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <vector>

#include "display/gl_object.h"

namespace brewster {

/// A linked pair of shaders. Setters make it the current program; a uniform it does not have is an Error.
class Program {
  public:
    /// Shaders by file name, see shader_source. Throws Error with the driver's log when one does not compile or link;
    /// what the driver says about a good one is logged as a warning.
    Program(const std::string& vertex, const std::string& fragment, const std::vector<std::string>& defines = {});

    bool has(const std::string& uniform) const { return uniforms_.count(uniform) != 0; }
    void use() const { glUseProgram(object_.id()); }
    void set(const std::string& uniform, int value) const;
    void set(const std::string& uniform, float value) const;
    void set(const std::string& uniform, glm::vec2 value) const;
    void set(const std::string& uniform, glm::uvec2 value) const;
    void set(const std::string& uniform, const glm::vec3& value) const;
    void set(const std::string& uniform, const glm::vec4& value) const;
    void set(const std::string& uniform, const glm::mat4& value) const;

  private:
    GLint location(const std::string& uniform) const;

    std::string name_;
    ProgramObject object_;
    std::map<std::string, GLint> uniforms_;
};

}  // namespace brewster
