#pragma once

namespace brewster {

/// For a window, before it opens: blocks of a megabyte get pages of their own, which the system gets back once they are
/// freed. A window makes an engine anew with every change, whose tallies take many megabytes; glibc would keep them in its
/// heaps, where what lives longer leaves holes between them, so that the window grew by megabytes a minute.
void keep_large_blocks_apart();

/// Gives the system the free pages of the holes that smaller blocks leave. Takes some milliseconds, in which other threads
/// may wait for memory; does nothing where the last time was less than ten seconds ago. Any thread.
void give_back_free_pages();

}  // namespace brewster
