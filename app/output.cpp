#include "app/output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/error.h"

namespace brewster {

void print_result(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) {
        throw Error(std::string("the result cannot be written (") + std::strerror(errno) + ")", "standard output",
                    "send it where there is room");
    }
}

}  // namespace brewster
