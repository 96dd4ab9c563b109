#pragma once
#include <string_view>

namespace brewster {

/// Prints a broken contract with its values and aborts.
[[noreturn]] void contract_broken(const char* file, int line, const char* condition, std::string_view values);

}  // namespace brewster

/// Our own bug: stays on in release builds. `values` is anything fmt can print into one string.
#define BREWSTER_CHECK(condition, values)                                                      \
    do {                                                                                       \
        if (!(condition)) ::brewster::contract_broken(__FILE__, __LINE__, #condition, values); \
    } while (false)
