#include <gtest/gtest.h>

#include <filesystem>

#include "app/process.h"

namespace brewster {
namespace {

namespace fs = std::filesystem;

/// A made-up machine: its PATH holds nothing but the programs written here, which log how they are called.
class Install : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fresh_folder();
        fs::create_directories(folder_ + "/bin");
        fs::create_symlink("/usr/bin/env", folder_ + "/bin/env");
        fs::create_symlink("/bin/cat", folder_ + "/bin/cat");
        write_text(folder_ + "/list", "# a comment\ng++   # compiler\nlibgood-dev # reason\nlibbad-dev\n");
        has("id", "echo ${FAKE_UID:-0}");
        has("apt-get", "echo \"apt-get $* [$DEBIAN_FRONTEND]\" >>\"$LOG\"; echo chatter; exit ${APT_STATUS:-0}");
        installed("g++ installed\nlibgood-dev installed\nlibbad-dev installed\n");
    }

    void has(const std::string& program, const std::string& script) {
        const std::string path = folder_ + "/bin/" + program;
        write_text(path, "#!/bin/bash\n" + script + "\n");
        fs::permissions(path, fs::perms::owner_all);
    }

    void installed(const std::string& table) {
        write_text(folder_ + "/table", table);
        has("dpkg-query", "echo \"dpkg-query $*\" >>\"$LOG.query\"; cat \"$TABLE\"; exit 1");
    }

    ProcessResult install(std::map<std::string, std::string> environment = {}) {
        environment["PATH"] = folder_ + "/bin";
        environment["LOG"] = folder_ + "/log";
        environment["TABLE"] = folder_ + "/table";
        ProcessSetting setting;
        setting.environment = environment;
        setting.empty_environment = true;
        return run_process({"/bin/bash", BREWSTER_SOURCE_DIR "/app/install", folder_ + "/list"}, setting);
    }

    std::string calls() const { return read_text(folder_ + "/log"); }

    std::string folder_;
};

TEST_F(Install, NothingMissingCallsNothing) {
    const ProcessResult result = install();
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.output + result.errors, "");
    EXPECT_EQ(calls(), "");
    EXPECT_EQ(read_text(folder_ + "/log.query"),
              "dpkg-query -W -f ${Package} ${db:Status-Status}\\n g++ libgood-dev libbad-dev\n");
}

TEST_F(Install, MissingPackagesAndNothingElseAreInstalled) {
    installed("g++ installed\nlibgood-dev config-files\n");
    const ProcessResult result = install();
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(result.output, "") << "standard output belongs to the program";
    EXPECT_EQ(calls(),
              "apt-get update -q []\n"
              "apt-get install -q -y --no-install-recommends libgood-dev libbad-dev [noninteractive]\n");
}

TEST_F(Install, SudoHelpsWhoIsNotRoot) {
    installed("g++ installed\nlibgood-dev installed\n");
    has("sudo", "echo -n 'sudo ' >>\"$LOG\"; exec \"$@\"");
    const ProcessResult result = install({{"FAKE_UID", "1000"}});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_EQ(calls(),
              "sudo apt-get update -q []\n"
              "sudo apt-get install -q -y --no-install-recommends libbad-dev [noninteractive]\n");
}

TEST_F(Install, WithoutRootAndSudoOneLineSaysWhatToDo) {
    installed("g++ installed\nlibgood-dev installed\n");
    const ProcessResult result = install({{"FAKE_UID", "1000"}});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_EQ(calls(), "");
    EXPECT_NE(result.errors.find("\napt-get update && apt-get install -y --no-install-recommends libbad-dev\n"),
              std::string::npos)
        << result.errors;
}

TEST_F(Install, FailingInstallationIsReported) {
    installed("");
    const ProcessResult result = install({{"APT_STATUS", "100"}});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.errors.find("could not be installed"), std::string::npos) << result.errors;
}

TEST_F(Install, OtherSystemsGoOn) {
    fs::remove(folder_ + "/bin/dpkg-query");
    const ProcessResult result = install();
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.errors.find("g++ libgood-dev libbad-dev"), std::string::npos) << result.errors;
    EXPECT_EQ(calls(), "");
}

}  // namespace
}  // namespace brewster
