#include "app/taken_picture.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/canvas.h"
#include "app/picture_names.h"
#include "app/pictures.h"
#include "base/priority.h"
#include "base/threads.h"
#include "display/gathered_light.h"
#include "display/legend.h"
#include "gather/gather.h"
#include "image/exr.h"
#include "image/png.h"

namespace brewster {

TakenPicture::TakenPicture(Order order) : order_(std::move(order)) {
    if (of_rays()) {
        gathered_ = std::async(std::launch::async, [this] { return gather(); });
        return;
    }
    picture_ = std::make_unique<Picture>(*order_.scene);
    picture_->show(order_.bins);
    picture_->upload();
    picture_->look(order_.view.camera, order_.width, order_.height);
}

TakenPicture::~TakenPicture() {
    stop_ = true;
}

StokesPicture TakenPicture::gather() {
    lower_priority(Priority::before_photons);
    Gather eye(std::make_shared<EyeScene>(*order_.scene), order_.seed);
    eye.show(order_.bins);
    eye.look(order_.view.camera, order_.width, order_.height);
    const auto stop = [this] { return stop_.load(std::memory_order_relaxed); };
    // In the two steps that it takes anyway, so that the share is known from the beginning.
    std::atomic<int> drawn = 0;
    constexpr double of_pilot = static_cast<double>(Gather::pilot_draws) / draws;
    const auto count = [&](double before, double step) {
        return [&, before, step](int) { share_ = before + step * ++drawn / eye.tiles(); };
    };
    eye.draw(Gather::pilot_draws, thread_count(), stop, count(0, of_pilot));
    drawn = 0;
    eye.draw(draws, thread_count(), stop, count(of_pilot, 1 - of_pilot));
    return eye.picture();
}

double TakenPicture::share() const {
    if (of_rays()) return share_;
    return static_cast<double>(picture_->draws(Canvas::needed(order_.view, false))) / draws;
}

bool TakenPicture::advance() {
    if (gathered_.valid()) {
        if (gathered_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
        const StokesPicture rays = gathered_.get();
        if (is_exr(order_.path)) {
            write_exr(stokes_image(rays, order_.view.rendition.polarization));
            return true;
        }
        GatheredLight light;
        light.upload(rays);
        write(light.textures());
        return true;
    }
    const Rendition needed = Canvas::needed(order_.view, false);
    picture_->draw(1, needed);
    if (picture_->draws(needed) < draws) return false;
    if (is_exr(order_.path))
        write_exr(picture_->stokes(order_.view.rendition.polarization));
    else
        write(picture_->light());
    return true;
}

void TakenPicture::write_exr(Image stokes) const {
    const Rendition& rendition = order_.view.rendition;
    describe_picture(stokes, {order_.scene->name, order_.view.camera.name, order_.bins->photons, rendition.polarization,
                              order_.seed, of_rays(), rendition.exposure});
    write_stokes_exr(order_.path, stokes);
}

void TakenPicture::write(const LightTextures& light) {
    const Screen screen = Screen::off_screen(order_.width, order_.height);
    const ScreenPass screen_pass;
    show_sight(screen_pass, screen, light, order_.view, false);
    Text text;
    if (order_.legend)
        draw_legend(text, screen,
                    {order_.view.rendition, order_.scene->name, order_.view.camera.name, order_.bins->photons});
    write_png(order_.path, screen.read());
}

}  // namespace brewster
