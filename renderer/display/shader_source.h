#pragma once
#include <string>
#include <vector>

namespace brewster {

/// A shader as one text, and the files it was spliced from: a compiler's message "2:14" means line 14 of files[2].
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;
};

/// Reads shaders from this folder instead of the copies inside the program; an empty path goes back to those.
void set_shader_folder(const std::string& path);

/// The shader file of that name ("chart.frag") behind `#version 330 core`, an empty BREWSTER_FUNCTION for the headers
/// shared with C++, and one `#define` a line of `defines`; each `#include "name"` is replaced by the file, once. Throws
/// Error when a file is missing.
ShaderSource shader_source(const std::string& name, const std::vector<std::string>& defines = {});

}  // namespace brewster
