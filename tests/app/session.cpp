#include "app/session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/settings.h"
#include "app/trace.h"

namespace brewster {
namespace {

class SessionTest : public testing::Test {
  protected:
    SessionTest() { settings_.threads = 1; }

    std::shared_ptr<const Scene> changed(const Session& session, const char* text) {
        auto scene = std::make_shared<Scene>(*session.scene());
        apply_settings(*scene, {*parse_setting(text)});
        return scene;
    }
    static void wait_for_light(Session& session) {
        for (int i = 0; i < 6000 && session.stale(); ++i) {
            session.advance();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        ASSERT_FALSE(session.stale());
    }

    EngineSettings settings_;
    StopRule rule_{.photons = 20000, .seconds = {}, .target_error = {}};
    std::shared_ptr<const Scene> room_ = load_scene("", {});
};

TEST_F(SessionTest, ChangesStartNewGenerationsAndUndoTakesThemBack) {
    Session session(room_, settings_, rule_);
    EXPECT_TRUE(session.stale());
    EXPECT_EQ(session.snapshot(), nullptr);
    wait_for_light(session);
    const auto before = session.snapshot();
    ASSERT_NE(before, nullptr);
    const std::uint64_t generation = session.generation();

    session.change(changed(session, "red.n=1.5"), true);
    EXPECT_GT(session.generation(), generation);
    EXPECT_TRUE(session.stale());
    EXPECT_EQ(session.snapshot(), nullptr);
    wait_for_light(session);
    EXPECT_NE(session.snapshot(), before);
    EXPECT_TRUE(session.replaced_after_ms().has_value());
    EXPECT_EQ(&session.engine()->scene(), session.scene().get());

    session.undo();
    EXPECT_EQ(session.scene(), room_);
    EXPECT_FALSE(session.can_undo());
    session.redo();
    EXPECT_NE(session.scene(), room_);
    wait_for_light(session);
}

TEST_F(SessionTest, ADragIsOneStepAndOnlyItsLastSceneIsTraced) {
    Session session(room_, settings_, rule_);
    session.change(changed(session, "red.albedo=0.1"), true);
    session.change(changed(session, "red.albedo=0.2"), false);
    session.change(changed(session, "red.albedo=0.3"), false);
    wait_for_light(session);
    EXPECT_EQ(&session.engine()->scene(), session.scene().get());
    session.undo();
    EXPECT_EQ(session.scene(), room_);
}

TEST_F(SessionTest, DarkScenesSaySoAndCanBeLitAgain) {
    Session session(room_, settings_, rule_);
    session.change(changed(session, "lamp.emission=0"), true);
    wait_for_light(session);
    EXPECT_EQ(session.engine(), nullptr);
    EXPECT_NE(session.trouble().find("no lamp gives light"), std::string::npos);
    session.undo();
    wait_for_light(session);
    EXPECT_NE(session.engine(), nullptr);
    EXPECT_EQ(session.trouble(), "");
}

TEST_F(SessionTest, PausesAndGoesOn) {
    Session session(room_, settings_, {});
    wait_for_light(session);
    session.pause();
    const std::uint64_t photons = session.engine()->progress().photons;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    EXPECT_EQ(session.engine()->progress().photons, photons);
    session.resume();
    for (int i = 0; i < 2000 && session.engine()->progress().photons == photons; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_GT(session.engine()->progress().photons, photons);
}

}  // namespace
}  // namespace brewster
