#include "bins/solution_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace brewster {
namespace {

class SolutionFile : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ = std::filesystem::temp_directory_path() / ("brewster-solution-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        path_ = (folder_ / "a.bins").string();
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    static SolutionWriter of(std::uint64_t number, std::size_t size = 3) {
        ByteWriter one, many;
        one.put(number);
        one.put_text("words");
        many.put_all(std::vector<std::uint64_t>(size, number));
        SolutionWriter file;
        file.add("one", one);
        file.add("many", many);
        return file;
    }
    static std::string content(const std::string& path) {
        std::ifstream stream(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    }
    void put(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }
    /// The sentence it is refused with; empty if it is not.
    std::string refusal() const {
        try {
            const SolutionReader file(path_);
            return "";
        } catch (const Error& error) {
            return error.what();
        }
    }

    std::filesystem::path folder_;
    std::string path_;
};

TEST_F(SolutionFile, HoldsWhatWasPutIn) {
    of(7).write(path_);
    const SolutionReader file(path_);
    ByteReader one = file.block("one"), many = file.block("many");
    EXPECT_EQ(one.get<std::uint64_t>(), 7u);
    EXPECT_EQ(one.get_text(), "words");
    EXPECT_TRUE(one.at_end());
    EXPECT_EQ(many.get_all<std::uint64_t>(), std::vector<std::uint64_t>(3, 7));
    EXPECT_THROW(many.get<char>(), Error);
    EXPECT_THROW(file.block("none"), Error);
    EXPECT_FALSE(std::filesystem::exists(path_ + ".part"));
}

TEST_F(SolutionFile, EveryCutIsNoticed) {
    of(7).write(path_);
    const std::string whole = content(path_);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        put(whole.substr(0, size));
        EXPECT_NE(refusal(), "") << size;
    }
    put(whole + "x");
    EXPECT_NE(refusal().find("behind its end"), std::string::npos);
    put(whole);
    EXPECT_EQ(refusal(), "");
}

TEST_F(SolutionFile, EveryFlippedBitIsNoticed) {
    of(7).write(path_);
    const std::string whole = content(path_);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        // Names of blocks have no checksum: a block is then missing.
        std::string bytes = whole;
        bytes[i] = static_cast<char>(bytes[i] ^ 4);
        put(bytes);
        bool noticed = !refusal().empty();
        if (!noticed) {
            const SolutionReader file(path_);
            try {
                file.block("one");
                file.block("many");
            } catch (const Error&) {
                noticed = true;
            }
        }
        EXPECT_TRUE(noticed) << i;
    }
}

TEST_F(SolutionFile, ForeignFilesAreRefusedInWords) {
    EXPECT_NE(refusal().find("no such file"), std::string::npos);
    put("glTF or anything else");
    EXPECT_NE(refusal().find("no saved solution"), std::string::npos);
    of(7).write(path_);
    std::string later = content(path_);
    later[8] = 9;
    put(later);
    EXPECT_NE(refusal().find("version 9"), std::string::npos);
    EXPECT_THROW(of(7).write((folder_ / "no folder" / "a.bins").string()), Error);
}

// A program that is killed while it saves, again and again, leaves the old file or the new one.
TEST_F(SolutionFile, AKillWhileSavingLeavesAWholeFile) {
    of(0).write(path_);
    int changed = 0, caught = 0;
    for (std::uint64_t round = 1; round <= 50; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            const SolutionWriter file = of(round, 1 << 16);
            for (;;) file.write(path_);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(600 * round));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        const SolutionReader file(path_);
        ByteReader one = file.block("one");
        changed += one.get<std::uint64_t>() == round;
        caught += std::filesystem::exists(path_ + ".part");
    }
    EXPECT_GT(changed, 0);  // some had saved,
    EXPECT_GT(caught, 0);   // some were at it
}

}  // namespace
}  // namespace brewster
