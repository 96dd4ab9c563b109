#pragma once
#include <map>
#include <string>
#include <vector>

namespace brewster {

struct ProcessResult {
    int exit_code = -1;  ///< 128 + signal for a program that was killed
    std::string output, errors;
};

struct ProcessSetting {
    std::string folder;                              ///< where it runs; empty: here
    std::map<std::string, std::string> environment;  ///< added to ours
    std::vector<std::string> without;                ///< names taken out of it
    bool empty_environment = false;                  ///< only `environment`
    int signal = 0;                                  ///< sent after signal_delay_ms, unless 0
    int signal_delay_ms = 0;
};

/// Runs a program, its path first, and waits for it.
ProcessResult run_process(const std::vector<std::string>& arguments, const ProcessSetting& setting = {});

/// The built program.
std::string brewster_program();

/// An empty folder of the calling test, with a space in its name.
std::string fresh_folder();

void write_text(const std::string& path, const std::string& text);
std::string read_text(const std::string& path);

}  // namespace brewster
