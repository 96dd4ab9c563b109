#pragma once
#include <stdexcept>
#include <string>

#include "base/one_line.h"

namespace brewster {

/// The world's fault: a file, a device, an argument. What is wrong, where, and what to do about it, on one line.
/// Caught in `main` and at the head of a worker thread; our own bugs are asserted instead (check.h).
class Error : public std::runtime_error {
  public:
    Error(const std::string& what_is_wrong, const std::string& where, const std::string& what_to_do)
        : std::runtime_error(one_line(where + ": " + what_is_wrong + "; " + what_to_do)) {}
};

}  // namespace brewster
