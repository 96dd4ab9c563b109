#pragma once
#include <string>

namespace brewster {

using GlFunction = void (*)();
using GlLoader = GlFunction (*)(const char* name);

/// Fetches the functions of the context that is current on this thread, through that context's own loader; to be called
/// whenever another context becomes current. Throws Error below OpenGL 3.3.
void load_gl(GlLoader loader);

/// "llvmpipe ..., OpenGL 4.5 ...": who draws.
std::string gl_description();

/// Throws Error when OpenGL has recorded an error since the last call; `where` names what was drawn.
void check_gl(const std::string& where);

}  // namespace brewster
