#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace brewster {

void contract_broken(const char* file, int line, const char* condition, std::string_view values) {
    std::fprintf(stderr, "brewster: bug at %s:%d: expected %s, but %.*s; please report this line\n", file, line,
                 condition, static_cast<int>(values.size()), values.data());
    std::abort();
}

}  // namespace brewster
