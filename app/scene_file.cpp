#include "app/scene_file.h"

#include <chrono>
#include <exception>
#include <utility>

namespace brewster {
namespace {

std::filesystem::file_time_type time_of(const std::string& path) {
    std::error_code unknown;
    const auto time = std::filesystem::last_write_time(path, unknown);
    return unknown ? std::filesystem::file_time_type{} : time;
}

}  // namespace

bool is_solution(const std::string& path) {
    return std::filesystem::path(path).extension() == ".bins";
}

SceneFile::SceneFile(std::string path, Read read)
    : path_(std::move(path)), read_(std::move(read)), seen_(time_of(path_)) {}

void SceneFile::open(const std::string& path) {
    wanted_ = path;
    if (reading_.valid()) return;  // its turn comes when that one is done
    being_read_ = std::exchange(wanted_, "");
    reading_ = std::async(std::launch::async, read_, being_read_, path_);
}

std::optional<SceneFile::Outcome> SceneFile::take() {
    if (!reading_.valid() || reading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    Outcome outcome;
    outcome.path = being_read_;
    outcome.again = being_read_ == path_;
    try {
        Solution found = reading_.get();
        outcome.scene = std::move(found.scene);
        outcome.engine = std::move(found.engine);
        if (!outcome.engine) path_ = being_read_;
        seen_ = time_of(path_);
    } catch (const std::exception& error) {
        outcome.complaint = error.what();
        if (outcome.again) seen_ = time_of(path_);  // said once, not until it changes again
    }
    if (!wanted_.empty()) {
        open(std::exchange(wanted_, ""));
        if (outcome.scene) outcome.scene = nullptr;
        outcome.complaint.clear();
    }
    if (!outcome.scene && outcome.complaint.empty()) return {};
    return outcome;
}

void SceneFile::look_for_changes() {
    if (path_.empty() || reading_.valid()) return;
    const auto time = time_of(path_);
    if (time == std::filesystem::file_time_type{} || time == seen_) return;
    open(path_);
}

}  // namespace brewster
