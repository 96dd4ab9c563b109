// The reference pictures of tests/images/reference: every camera of every scene at the sizes of the peer's pictures with
// polarization, without it where any surface polarizes, and each scene's first camera at 320 x 240.
//   bench_references [--seconds S] [--threads T] [NAME...]
// gives each picture whose name begins with one of NAME (all of them without any) as much time as it lacks to S seconds,
// in passes of at most 20 s. A pass has a seed of its own and is averaged with what the file holds; the file is replaced
// after each, so the command may be stopped and started again at any time. Ends with the table of the README.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "image/exr.h"
#include "reference/reference.h"
#include "scene/needs.h"

namespace {

using namespace brewster;

const std::string root = BREWSTER_SOURCE_DIR;
constexpr double longest_pass = 20, inaccuracy = 0.5;  // seconds

struct Job {
    std::string scene, camera;
    int width = 0, height = 0;
    bool polarized = true;

    std::string name() const {
        return scene + "-" + camera + (width == 320 ? "-320x240" : "") + (polarized ? "" : "-off");
    }
    std::string path() const { return root + "/tests/images/reference/" + name() + ".exr"; }
};

/// What a picture is made of so far.
struct Progress {
    Image picture;
    double samples = 0, photons = 0;  // a pixel
    double seconds = 0;
    int passes = 0;
};

std::vector<Job> all_jobs() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(root + "/assets/scenes"))
        if (entry.path().extension() == ".gltf") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Job> jobs;
    for (const std::filesystem::path& file : files) {
        const std::string name = file.stem().string();
        const Scene scene = read_scene(file.string());
        const bool polarizes = needs_of(scene).stokes > 1;
        for (const Camera& camera : scene.cameras) {
            const int width = static_cast<int>(std::lround(96 * camera.aspect_ratio));
            jobs.push_back({name, camera.name, width, 96, true});
            if (polarizes) jobs.push_back({name, camera.name, width, 96, false});
        }
        if (name != "furnace")  // where every pixel is 2
            jobs.push_back({name, scene.cameras.front().name, 320, 240, true});
    }
    return jobs;
}

double number(const Image& picture, const std::string& name) {
    for (const auto& [key, text] : picture.attributes)
        if (key == name) return std::atof(text.c_str());
    return 0;
}

std::optional<Progress> so_far(const Job& job) {
    if (!std::filesystem::exists(job.path())) return {};
    Progress progress;
    progress.picture = read_exr(job.path());
    progress.samples = number(progress.picture, "brewster.samples");
    progress.photons = number(progress.picture, "brewster.photons");
    progress.seconds = number(progress.picture, "brewster.seconds");
    progress.passes = static_cast<int>(number(progress.picture, "brewster.passes"));
    return progress;
}

/// Adds to `sum` another picture, as the mean of both by the number of their paths.
void average(Progress& sum, const Progress& more) {
    const Image& picture = more.picture;
    const double total = sum.samples + sum.photons + more.samples + more.photons;
    const double other = (more.samples + more.photons) / total, own = 1 - other;
    for (const std::string& name : picture.channel_names()) {
        const bool variance = is_variance_channel(name);
        std::vector<float>& mean = sum.picture.channel(name);
        const std::vector<float>& added = picture.channel(name);
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] = static_cast<float>(static_cast<double>(mean[i]) * (variance ? own * own : own) +
                                         static_cast<double>(added[i]) * (variance ? other * other : other));
    }
    sum.samples += more.samples;
    sum.photons += more.photons;
}

void save(const Job& job, Progress& progress) {
    progress.picture.attributes = {{"brewster.scene", job.scene},
                                   {"brewster.camera", job.camera},
                                   {"brewster.polarization", job.polarized ? "on" : "off"},
                                   {"brewster.samples", std::to_string(static_cast<long>(progress.samples))},
                                   {"brewster.photons", std::to_string(progress.photons)},
                                   {"brewster.seconds", std::to_string(progress.seconds)},
                                   {"brewster.passes", std::to_string(progress.passes)}};
    const std::string unfinished = job.path() + ".part";
    write_stokes_exr(unfinished, progress.picture, ExrPrecision::half);
    std::filesystem::rename(unfinished, job.path());
}

void pass(const Job& job, const Scene& scene, double seconds, unsigned threads, std::optional<Progress>& progress) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const int seed = progress ? progress->passes + 1 : 1;
    Reference reference(scene, scene.camera(job.camera), job.width, job.height, job.polarized,
                        static_cast<std::uint64_t>(seed), threads);
    reference.add_samples(2);
    while (elapsed() < seconds) {
        const double rate = static_cast<double>(reference.samples()) / elapsed();
        const double passage = std::min(seconds - elapsed(), 0.5);  // short: the rate changes after the pilot
        reference.add_samples(static_cast<std::uint64_t>(std::max(rate * passage, 1.0)));
    }
    const Progress found{reference.picture(), static_cast<double>(reference.samples()),
                         static_cast<double>(reference.photons()) / (job.width * job.height), 0, 0};
    if (progress)
        average(*progress, found);
    else
        progress = found;
    progress->seconds += elapsed();
    progress->passes = seed;
    save(job, *progress);
}

/// Root mean square over the pixels of their relative standard error, e = 1 % of the mean (as `compare` has it).
double relative_error(const Image& picture) {
    double sum = 0;
    for (int band = 0; band < band_count; ++band) {
        const double floor = 0.01 * mean_of(picture, 0, band).mean;
        const std::vector<float>&value = picture.channel(stokes_channel(0, band)),
              &variance = picture.channel(variance_channel(0, band));
        for (std::size_t i = 0; i < value.size(); ++i) {
            const auto x = static_cast<double>(value[i]);
            sum += static_cast<double>(variance[i]) / (x * x + floor * floor);
        }
    }
    return std::sqrt(sum / static_cast<double>(band_count * picture.pixel_count()));
}

bool wanted(const Job& job, const std::vector<std::string>& names) {
    return names.empty() ||
           std::any_of(names.begin(), names.end(), [&](const std::string& n) { return job.name().starts_with(n); });
}

}  // namespace

int main(int count, char** arguments) try {
    double seconds = 20;
    unsigned threads = 2;
    std::vector<std::string> names;
    for (int k = 1; k < count; ++k) {
        const std::string word = arguments[k];
        if (word == "--seconds" && k + 1 < count)
            seconds = std::atof(arguments[++k]);
        else if (word == "--threads" && k + 1 < count)
            threads = static_cast<unsigned>(std::max(std::atoi(arguments[++k]), 1));
        else
            names.push_back(word);
    }
    std::filesystem::create_directories(root + "/tests/images/reference");
    std::printf("| picture | seconds | samples | photons a pixel | mean S0 (green) | pixels' relative error |\n");
    std::printf("|---|---|---|---|---|---|\n");
    for (const Job& job : all_jobs()) {
        if (!wanted(job, names)) continue;
        const Scene scene = read_scene(root + "/assets/scenes/" + job.scene + ".gltf");
        std::optional<Progress> progress = so_far(job);
        while (!progress || progress->seconds < seconds - inaccuracy)
            pass(job, scene, std::min(seconds - (progress ? progress->seconds : 0), longest_pass), threads, progress);
        const PictureMean mean = mean_of(progress->picture, 0, 1);
        std::printf("| %s | %.0f | %.0f | %.0f | %.5g +- %.2g %% | %.2g %% |\n", job.name().c_str(), progress->seconds,
                    progress->samples, progress->photons, mean.mean, 100 * mean.standard_error / mean.mean,
                    100 * relative_error(progress->picture));
        std::fflush(stdout);
    }
    return 0;
} catch (const std::exception& failure) {
    std::cerr << failure.what() << "\n";
    return 1;
}
