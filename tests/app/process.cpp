#include "app/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

namespace brewster {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void become(const std::vector<std::string>& arguments, const ProcessSetting& setting,
                         const std::string& output, const std::string& errors) {
    if (!setting.folder.empty() && chdir(setting.folder.c_str()) != 0) _exit(126);
    const auto redirect = [](const std::string& path, int target) {
        const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (file < 0 || dup2(file, target) < 0) _exit(126);
    };
    redirect(output, STDOUT_FILENO);
    redirect(errors, STDERR_FILENO);
    if (setting.empty_environment) clearenv();
    for (const std::string& name : setting.without) unsetenv(name.c_str());
    for (const auto& [name, value] : setting.environment) setenv(name.c_str(), value.c_str(), 1);
    std::vector<char*> words;
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    execv(words.front(), words.data());
    _exit(127);
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& arguments, const ProcessSetting& setting) {
    const fs::path base = fs::temp_directory_path() / ("brewster-test-" + std::to_string(getpid()));
    const std::string output = base.string() + ".out", errors = base.string() + ".err";
    const pid_t child = fork();
    if (child == 0) become(arguments, setting, output, errors);
    if (setting.signal != 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(setting.signal_delay_ms));
        kill(child, setting.signal);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ProcessResult result{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read_text(output),
                         read_text(errors)};
    fs::remove(output);
    fs::remove(errors);
    return result;
}

std::string brewster_program() {
    return BREWSTER_BINARY_DIR "/app/brewster";
}

std::string fresh_folder() {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    const fs::path folder = fs::path(BREWSTER_BINARY_DIR) / "tests" / "scratch space" /
                            (std::string(test.test_suite_name()) + "." + test.name());
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder.string();
}

void write_text(const std::string& path, const std::string& text) {
    std::ofstream stream(path);
    stream << text;
    ASSERT_TRUE(stream.flush()) << path;
}

std::string read_text(const std::string& path) {
    std::ifstream stream(path);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace brewster
