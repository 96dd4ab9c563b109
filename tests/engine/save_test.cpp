#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.h"
#include "engine/engine.h"
#include "engine/saved_settings.h"
#include "slow.h"
#include "trace.h"
#include "transport/rooms.h"

namespace brewster {
namespace {

class Save : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("brewster-save-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        path_ = (folder_ / "a.bins").string();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path folder_;
    std::string path_;
};

// N, then M from the file, is N + M at once: to the bit, inside a batch and at the end of one, whatever the threads.
TEST_F(Save, ResumedPhotonsAreThoseThatWouldHaveComeNext) {
    const std::uint64_t all = slow ? 40000 : 150000;
    for (const char* name : {"brewster-room.gltf", "gloss-lab.gltf"}) {
        const auto scene = rooms::read(name);
        EngineSettings settings;
        settings.threads = 2;
        settings.seed = 5;
        Engine through(scene, settings);
        trace(through, all);
        for (const std::uint64_t first : {std::uint64_t{8192}, all / 3 + 77}) {
            Engine before(scene, settings);
            trace(before, first);
            before.save(path_);

            const SolutionReader file(path_);
            EngineSettings again = saved_settings(file).engine;
            EXPECT_EQ(again.seed, 5u);
            again.threads = 1;
            Engine after(scene, again);
            after.load(file);
            EXPECT_EQ(after.progress().photons, first);
            EXPECT_EQ(after.digest(), before.digest());
            ASSERT_TRUE(after.snapshot());
            EXPECT_EQ(after.snapshot()->leaves, before.snapshot()->leaves);
            EXPECT_EQ(after.snapshot()->gloss.leaves, before.snapshot()->gloss.leaves);
            trace(after, all);
            EXPECT_EQ(after.digest(), through.digest()) << name << " after " << first;
            EXPECT_EQ(after.ledger().emitted, through.ledger().emitted);
            EXPECT_TRUE(after.ledger().balances());
            EXPECT_EQ(after.progress().bounces, through.progress().bounces);
        }
    }
}

TEST_F(Save, OtherScenesAndSettingsAreRefusedInWords) {
    const auto scene = rooms::read("cornell-box.gltf");
    Engine engine(scene, {});
    trace(engine, 2000);
    engine.save(path_);
    const SolutionReader file(path_);
    const auto refusal = [&](const std::shared_ptr<const Scene>& of, const EngineSettings& settings) -> std::string {
        Engine other(of, settings);
        try {
            other.load(file);
            return "";
        } catch (const Error& error) {
            return error.what();
        }
    };
    EXPECT_EQ(refusal(scene, {}), "");
    EXPECT_NE(refusal(rooms::read("furnace.gltf"), {}).find("another scene, called \"cornell-box\""),
              std::string::npos);
    Scene changed = *scene;
    changed.materials[0].albedo.x *= 0.999f;
    EXPECT_NE(refusal(std::make_shared<const Scene>(changed), {}).find("another scene"), std::string::npos);
    Scene moved = *scene;
    moved.cameras[0].position.x += 1;  // photons do not know
    EXPECT_EQ(refusal(std::make_shared<const Scene>(moved), {}), "");
    EngineSettings seed;
    seed.seed = 2;
    EXPECT_NE(refusal(scene, seed).find("other settings"), std::string::npos);
}

// A file whose checksums are right and whose numbers are not: refused or loaded, never a crash.
TEST_F(Save, BlocksThatContradictEachOtherAreRefused) {
    const auto scene = rooms::read("cornell-box.gltf");
    Engine engine(scene, {});
    trace(engine, 2000);
    engine.save(path_);
    const std::vector<std::string> names = {"settings", "books", "entry", "gloss", "guide"};
    int refused = 0;
    for (const std::string& broken : names) {
        const SolutionReader whole(path_);
        for (const std::size_t byte :
             slow ? std::vector<std::size_t>{9, 40001} : std::vector<std::size_t>{0, 9, 40, 333, 2000, 40001}) {
            SolutionWriter file;
            for (const std::string& name : names) {
                ByteReader from = whole.block(name);
                std::string bytes;
                while (!from.at_end()) bytes += from.get<char>();
                if (name == broken && byte < bytes.size()) bytes[byte] = static_cast<char>(bytes[byte] ^ 0x55);
                if (name == broken && byte >= bytes.size()) bytes.pop_back();
                ByteWriter block;
                for (const char each : bytes) block.put(each);
                file.add(name, block);
            }
            const std::string path = path_ + ".broken";
            file.write(path);
            const SolutionReader damaged(path);
            Engine other(scene, {});
            try {
                other.load(damaged);
            } catch (const Error&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, slow ? 4 : 15);  // what is left changed sums, as a checksum would have said
}

}  // namespace
}  // namespace brewster
