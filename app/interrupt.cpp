#include "app/interrupt.h"

namespace brewster {
namespace {

volatile std::sig_atomic_t signal_seen = 0;

extern "C" void note_signal(int) {
    signal_seen = 1;
}

}  // namespace

InterruptScope::InterruptScope() {
    signal_seen = 0;
    struct sigaction action {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, &before_interrupt_);
    sigaction(SIGTERM, &action, &before_terminate_);
}

InterruptScope::~InterruptScope() {
    sigaction(SIGINT, &before_interrupt_, nullptr);
    sigaction(SIGTERM, &before_terminate_, nullptr);
}

bool InterruptScope::interrupted() const {
    return signal_seen != 0;
}

}  // namespace brewster
