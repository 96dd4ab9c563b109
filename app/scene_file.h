#pragma once
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "app/trace.h"

namespace brewster {

/// Whether a path ends in .bins: a saved solution.
bool is_solution(const std::string& path);

/// The file that a scene came from: read beside the window, and read again when it changes.
class SceneFile {
  public:
    /// `path`: what to open, a scene or a saved solution of the scene in the file `scene`.
    using Read = std::function<Solution(const std::string& path, const std::string& scene)>;

    /// `path` empty: the scene in the binary, which never changes.
    SceneFile(std::string path, Read read);

    const std::string& path() const { return path_; }
    bool reading() const { return reading_.valid(); }

    /// Begins to read another file, or a saved solution of this one; one that is being read is forgotten.
    void open(const std::string& path);

    /// What came of it, once.
    struct Outcome {
        std::shared_ptr<const Scene> scene;  ///< null: `complaint` says why, and the old file stays
        std::unique_ptr<Engine> engine;      ///< of a saved solution; null: of a scene
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
    std::future<Solution> reading_;
    std::string being_read_;
    std::filesystem::file_time_type seen_{};
};

}  // namespace brewster
