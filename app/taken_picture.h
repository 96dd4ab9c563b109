#pragma once
#include <atomic>
#include <cstdint>
#include <future>
#include <memory>
#include <string>

#include "app/state.h"
#include "bins/snapshot.h"
#include "display/picture.h"
#include "image/image.h"
#include "image/stokes_picture.h"
#include "scene/scene.h"

namespace brewster {

/// A picture for a file, drawn anew from the bins of one moment, as `brewster shot` draws it: what the window has drawn
/// before has no part in it.
class TakenPicture {
  public:
    struct Order {
        std::string path;  ///< .png or .exr
        std::shared_ptr<const Scene> scene;
        std::shared_ptr<const Snapshot> bins;
        Sight view;
        int width = 0, height = 0;
        std::uint64_t seed = 1;  ///< of the eye's rays
        bool legend = true;
    };
    static constexpr int draws = Picture::full_draws;

    explicit TakenPicture(Order order);
    ~TakenPicture();
    TakenPicture(const TakenPicture&) = delete;
    TakenPicture& operator=(const TakenPicture&) = delete;

    const std::string& path() const { return order_.path; }

    /// Does a little more, or looks whether the rays are done; needs the window's context. True once the file is
    /// written. Throws Error when it cannot be.
    bool advance();
    bool of_rays() const { return order_.view.of_rays(); }  ///< made by threads of its own
    double share() const;                                   ///< of its samples that are made, 0 to 1

  private:
    StokesPicture gather();
    void write(const LightTextures& light);
    void write_exr(Image stokes) const;

    Order order_;
    std::unique_ptr<Picture> picture_;  ///< of bins
    std::atomic<bool> stop_ = false;
    std::atomic<double> share_ = 0;  ///< of rays
    std::future<StokesPicture> gathered_;
};

}  // namespace brewster
