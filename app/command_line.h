#pragma once
#include <string>

#include "app/options.h"

namespace brewster {

/// Where the arguments lead to no command: what to print, and how to exit: 0 for --help and --version, 2 for bad usage.
struct CommandLineEnd {
    std::string text;
    int exit_code = 2;
};

/// Reads the program's arguments. Throws CommandLineEnd.
Command parse_command_line(int argc, const char* const* argv);

}  // namespace brewster
