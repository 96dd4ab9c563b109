#pragma once
#include <gtest/gtest.h>

#include "engine/engine.h"

namespace brewster {

/// Traces so many photons (on top of what there is) and waits; no quantum of light may get lost on the way.
inline void trace(Engine& engine, std::uint64_t photons) {
    StopRule rule;
    rule.photons = photons;
    engine.start(rule);
    engine.wait();
    EXPECT_TRUE(engine.ledger().balances());
}

}  // namespace brewster
