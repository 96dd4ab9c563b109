#include "app/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "app/settings.h"
#include "app/trace.h"

namespace brewster {
namespace {

class SessionTest : public testing::Test {
  protected:
    SessionTest() { settings_.threads = 1; }

    static void change(Session& session, const char* text, bool new_step) {
        auto scene = std::make_shared<Scene>(*session.scene());
        const Setting setting = *parse_setting(text);
        apply_settings(*scene, {setting});
        session.change(std::move(scene), setting, new_step);
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

    change(session, "red.n=1.5", true);
    EXPECT_GT(session.generation(), generation);
    EXPECT_TRUE(session.stale());
    EXPECT_EQ(session.snapshot(), nullptr);
    wait_for_light(session);
    EXPECT_NE(session.snapshot(), before);
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
    change(session, "red.albedo=0.1", true);
    change(session, "red.albedo=0.2", false);
    change(session, "red.albedo=0.3", false);
    wait_for_light(session);
    EXPECT_EQ(&session.engine()->scene(), session.scene().get());
    session.undo();
    EXPECT_EQ(session.scene(), room_);
}

TEST_F(SessionTest, WhileChangesKeepComingLightDoesToo) {
    Session session(room_, settings_, rule_);
    wait_for_light(session);
    std::uint64_t shown = session.generation(), pictures = 0;
    for (int i = 0; i < 2000 && pictures < 3; ++i) {
        change(session, ("red.albedo=" + std::to_string(0.1 + 1e-4 * i)).c_str(), i == 0);
        session.advance();
        if (const auto traced = session.traced()) {
            EXPECT_EQ(traced->scene == session.scene(), traced->generation == session.generation());
            if (traced->generation > shown && traced->bins) ++pictures;
            shown = std::max(shown, traced->generation);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_EQ(pictures, 3u);
    EXPECT_TRUE(session.stale());
    wait_for_light(session);
    EXPECT_EQ(session.traced()->scene, session.scene());
    EXPECT_FALSE(session.overdue());
}

TEST_F(SessionTest, DarkScenesSaySoAndCanBeLitAgain) {
    Session session(room_, settings_, rule_);
    change(session, "lamp.emission=0", true);
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

TEST_F(SessionTest, KeepsItsSolutionWithAllChangesAndTakesItUpAgain) {
    Session session(room_, settings_, rule_);
    change(session, "red.n=1.5", true);
    change(session, "red.roughness=0.4", true);
    change(session, "red.roughness=0.5", false);
    change(session, "lamp.emission=9", true);
    session.undo();
    wait_for_light(session);
    const std::string path = testing::TempDir() + "session.bins";
    session.save(path);
    std::optional<std::string> saved;
    for (int i = 0; i < 2000 && !(saved = session.take_saved()); ++i) {
        session.advance();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_EQ(saved, "");

    SolveOptions options;
    options.resume = path;
    options.engine.threads = 1;
    Solution solution = saved_solution(options);
    const std::vector<std::string> changes = solution.engine->settings().changes;
    EXPECT_EQ(changes, (std::vector<std::string>{"red.n=1.5", "red.roughness=0.5"}));
    EXPECT_GT(solution.engine->progress().photons, 0u);

    const Engine* engine = solution.engine.get();
    session.open(solution.scene, changes, std::move(solution.engine));
    wait_for_light(session);
    EXPECT_EQ(session.engine(), engine);
    EXPECT_TRUE(session.paused());
    EXPECT_FALSE(session.can_undo());
    session.save(testing::TempDir() + "no such folder/session.bins");
    for (int i = 0; i < 2000 && !(saved = session.take_saved()); ++i) {
        session.advance();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_NE(saved.value_or(""), "");
}

}  // namespace
}  // namespace brewster
