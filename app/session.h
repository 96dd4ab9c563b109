#pragma once
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/settings.h"
#include "engine/engine.h"
#include "scene/scene.h"

namespace brewster {

/// A scene that is looked at, with the engine that traces it, and all the scenes it was before. A change of the scene
/// starts a new generation: an engine of its own, made beside the window. Of changes that come before it has shown light
/// only the last counts, and is traced next: while a slider is dragged, picture follows picture. For the window's
/// thread; never blocks it but for a moment.
class Session {
  public:
    Session(std::shared_ptr<const Scene> scene, const EngineSettings& settings, const StopRule& rule);
    ~Session();

    const std::shared_ptr<const Scene>& scene() const { return now_.scene; }  ///< as changed last
    Engine* engine() const { return engine_.get(); }  ///< null while one is made, or where no lamp gives light
    /// Grows with every change of the scene and every restart.
    std::uint64_t generation() const { return generation_; }

    /// The generation whose light is to be shown. While the newest has none yet that is one before it, or none.
    struct Traced {
        std::shared_ptr<const Scene> scene;
        std::uint64_t generation = 0;
        std::shared_ptr<const Snapshot> bins;  ///< null where no lamp gives light
    };
    /// Good enough to be shown: an estimated error below 15 %, or all there is so soon after the change that it stands
    /// on the screen after about 100 ms.
    std::optional<Traced> traced() const;
    /// The bins of the present generation, or null before its first that are to be shown.
    std::shared_ptr<const Snapshot> snapshot() const;
    /// No light of the present generation is there to be shown.
    bool stale() const { return !ready_ || traced_generation_ != generation_; }
    /// It has been so for longer than a person takes for at once.
    bool overdue() const;

    /// Looks whether a new engine or its first bins are there.
    void advance();

    /// The scene with a setting changed. The first of a row that undo takes back as one begins a `new_step`.
    void change(std::shared_ptr<const Scene> changed, const Setting& setting, bool new_step);
    bool can_undo() const { return !done_.empty(); }
    bool can_redo() const { return !undone_.empty(); }
    void undo();
    void redo();
    /// Another scene altogether, changed so since its file was read: nothing to undo. `engine`: with what was traced of
    /// it before; null: from the first photon.
    void open(std::shared_ptr<const Scene> scene, std::vector<std::string> changes, std::unique_ptr<Engine> engine);

    void restart();  ///< from the first photon
    void pause();
    void resume();
    bool paused() const { return paused_; }
    void set_target_error(std::optional<double> error);

    /// Keeps what is traced in a file, beside the window; no photon flies meanwhile.
    void save(const std::string& path);
    bool saving() const { return saving_.valid(); }
    /// What came of it, once: empty, or why it failed.
    std::optional<std::string> take_saved();
    const StopRule& rule() const { return rule_; }

    /// Why there is no engine, or why it ended; empty otherwise.
    const std::string& trouble() const { return trouble_; }

  private:
    struct Made {
        std::unique_ptr<Engine> engine;
        std::optional<StopRule> rule;  ///< that it was started with; none: it was not
        std::string trouble;
    };

    /// A scene and how it differs from its file.
    struct Version {
        std::shared_ptr<const Scene> scene;
        std::vector<std::string> changes;
    };

    void begin_generation(std::unique_ptr<Engine> engine = nullptr);
    void begin_change();
    void take_step(std::vector<Version>& from, std::vector<Version>& to);
    void go_on();
    bool free_for_change() const;
    void make();
    void take_made();
    void retire(std::unique_ptr<Engine> engine);

    Version now_;
    EngineSettings settings_;
    StopRule rule_;
    std::unique_ptr<Engine> engine_;
    std::shared_ptr<const Scene> traced_scene_;
    std::uint64_t generation_ = 0, traced_generation_ = 0;
    std::future<Made> making_;
    bool discard_ = false;  ///< what is being made
    std::vector<std::future<void>> retiring_;
    std::vector<Version> done_, undone_;
    std::shared_future<void> saving_;
    std::optional<std::string> saved_;
    bool paused_ = false;
    bool ready_ = false;      ///< there is light to show of what is traced
    bool offered_ = false;    ///< for one turn at least
    double begun_at_ = 0;     ///< what is traced
    double answered_at_ = 0;  ///< when light was as it should be for the last time, or newer than before
    std::string trouble_;
};

}  // namespace brewster
