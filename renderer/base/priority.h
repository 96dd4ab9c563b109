#pragma once
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace brewster {

/// What threads beside a window yield to: the window, or photons, too.
enum class Priority { before_photons = 5, lowest = 10 };

/// Of the calling thread and of those it starts from now on. On Linux a priority belongs to a thread.
inline void lower_priority(Priority priority) {
    setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), static_cast<int>(priority));
}

}  // namespace brewster
