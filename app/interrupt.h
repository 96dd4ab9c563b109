#pragma once
#include <csignal>

namespace brewster {

/// While one lives, the first Ctrl+C (or a polite kill) is only noted; the second ends the program as usual.
class InterruptScope {
  public:
    InterruptScope();
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;

    bool interrupted() const;

  private:
    struct sigaction before_interrupt_ {};
    struct sigaction before_terminate_ {};
};

}  // namespace brewster
