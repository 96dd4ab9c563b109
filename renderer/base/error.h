#pragma once
#include <stdexcept>
#include <string>

namespace brewster {

/// The world's fault: a file, a device, an argument. What is wrong, where, and what to do about it.
/// Caught in `main` and at the head of a worker thread; our own bugs are asserted instead (check.h).
class Error : public std::runtime_error {
  public:
    Error(const std::string& what_is_wrong, const std::string& where, const std::string& what_to_do)
        : std::runtime_error(where + ": " + what_is_wrong + "; " + what_to_do) {}
};

}  // namespace brewster
