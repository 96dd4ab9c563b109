#pragma once
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace brewster {

/// The file that a scene came from: read beside the window, and read again when it changes.
class SceneFile {
  public:
    using Read = std::function<std::shared_ptr<const Scene>(const std::string& path)>;

    /// `path` empty: the scene in the binary, which never changes.
    SceneFile(std::string path, Read read);

    const std::string& path() const { return path_; }
    bool reading() const { return reading_.valid(); }

    /// Begins to read another file; one that is being read is forgotten.
    void open(const std::string& path);

    /// What came of it, once.
    struct Outcome {
        std::shared_ptr<const Scene> scene;  ///< null: `complaint` says why, and the old file stays
        std::string path, complaint;
        bool again = false;  ///< the same file, changed
    };
    std::optional<Outcome> take();

    /// Reads the file again if it has changed since it was read. Cheap; asks the disc.
    void look_for_changes();

  private:
    std::string path_;
    Read read_;
    std::string wanted_;
    std::future<std::shared_ptr<const Scene>> reading_;
    std::string being_read_;
    std::filesystem::file_time_type seen_{};
};

}  // namespace brewster
