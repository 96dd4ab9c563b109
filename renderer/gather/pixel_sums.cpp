#include "gather/pixel_sums.h"

#include <algorithm>
#include <cmath>

namespace brewster {
namespace {

constexpr int pool_radius = 3;
constexpr double dark_share = 0.01;   // of the mean radiance, below which errors count against that
constexpr float error_power = 0.45f;  // of the squared error
constexpr std::uint32_t most_draws = 1u << 20;

/// Sums over (2 r + 1)^2 pixels around each, cut at the border.
class BoxSums {
  public:
    BoxSums(int width, int height) : width_(width), height_(height) {}

    std::vector<float> operator()(const std::vector<float>& values) const {
        std::vector<float> rows(values.size()), sums(values.size());
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                float sum = 0;
                for (int i = std::max(x - pool_radius, 0); i <= std::min(x + pool_radius, width_ - 1); ++i)
                    sum += values[at(i, y)];
                rows[at(x, y)] = sum;
            }
        for (int y = 0; y < height_; ++y)
            for (int i = std::max(y - pool_radius, 0); i <= std::min(y + pool_radius, height_ - 1); ++i)
                for (int x = 0; x < width_; ++x) sums[at(x, y)] += rows[at(x, i)];
        return sums;
    }

  private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_, height_;
};

/// Variance of the mean as two replicas show it, with one degree of freedom.
float replica_variance(const PixelSum& pixel, double a, double b) {
    const double n = pixel.draws, n_b = pixel.draws / 2, n_a = n - n_b;
    if (n_b == 0) return 0;
    const double difference = a / n_a - b / n_b;
    return static_cast<float>(difference * difference * n_a * n_b / (n * n));
}

/// Variance of the mean if all draws were independent.
float independent_variance(const PixelSum& pixel, double sum, double squares) {
    const double n = pixel.draws;
    if (n < 2) return 0;
    const double mean = sum / n;
    return static_cast<float>(std::max(0.0, squares / n - mean * mean) / (n - 1));
}

constexpr std::size_t first_unpolarized = static_cast<std::size_t>(Plane::unpolarized) * band_count;

}  // namespace

void add_draws(const LevelLight& seen, int components, std::size_t first, std::size_t count, PixelSum& pixel) {
    std::array<std::array<double, plane_values>, 2> sums{};
    std::array<double, plane_values + band_count> squares{};
    std::array<double, 3 * band_count> errors{};
    double coarse = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t i = first + k;
        auto& replica = sums[(pixel.draws + k) % 2];
        const auto take = [&](std::size_t value, float light) {
            const auto x = static_cast<double>(light);
            replica[value] += x;
            squares[value] += x * x;
        };
        for (std::size_t value = 0; value < 3 * static_cast<std::size_t>(components); ++value)
            take(value, seen.stokes[value][i]);
        for (std::size_t band = 0; band < band_count; ++band) {
            const float on = seen.stokes[band][i];
            const float off = components > 1 ? seen.unpolarized[band][i] : on;
            take(first_unpolarized + band, off);
            const auto difference = static_cast<double>(on - off);
            squares[plane_values + band] += difference * difference;
            errors[band] += static_cast<double>(seen.error[band][i]);
            errors[3 + band] += static_cast<double>(seen.polarized_error[band][i]);
            errors[6 + band] +=
                static_cast<double>(components > 1 ? seen.unpolarized_error[band][i] : seen.error[band][i]);
        }
        coarse += static_cast<double>(seen.coarse[i]);
    }
    pixel.draws += static_cast<std::uint32_t>(count);
    const auto add = [](float& to, double what) { to = static_cast<float>(static_cast<double>(to) + what); };
    for (std::size_t replica = 0; replica < 2; ++replica)
        for (std::size_t value = 0; value < plane_values; ++value)
            add(pixel.sums[replica][value], sums[replica][value]);
    for (std::size_t value = 0; value < squares.size(); ++value) add(pixel.squares[value], squares[value]);
    for (std::size_t band = 0; band < band_count; ++band) {
        add(pixel.error[band], errors[band]);
        add(pixel.polarized_error[band], errors[3 + band]);
        add(pixel.unpolarized_error[band], errors[6 + band]);
    }
    add(pixel.coarse, coarse);
}

StokesPicture picture_of(const std::vector<PixelSum>& pixels, int width, int height) {
    StokesPicture picture(width, height);
    const BoxSums pooled(width, height);
    std::vector<float> replica(pixels.size()), independent(pixels.size());
    // Groups of values that share one gain: s0; s1, s2, s3; unpolarized; the difference of the worlds.
    constexpr std::array<std::size_t, 5> bounds = {0, 3, 12, 15, 18};
    for (std::size_t group = 0; group + 1 < bounds.size(); ++group) {
        std::fill(replica.begin(), replica.end(), 0.0f);
        std::fill(independent.begin(), independent.end(), 0.0f);
        const auto sums_of = [&](const PixelSum& pixel, std::size_t value) -> std::array<double, 2> {
            const auto read = [&](std::size_t r, std::size_t v) { return static_cast<double>(pixel.sums[r][v]); };
            if (value < plane_values) return {read(0, value), read(1, value)};
            const std::size_t band = value - plane_values;
            return {read(0, band) - read(0, first_unpolarized + band),
                    read(1, band) - read(1, first_unpolarized + band)};
        };
        for (std::size_t value = bounds[group]; value < bounds[group + 1]; ++value)
            for (std::size_t p = 0; p < pixels.size(); ++p) {
                const auto [a, b] = sums_of(pixels[p], value);
                replica[p] += replica_variance(pixels[p], a, b);
                independent[p] += independent_variance(pixels[p], a + b, static_cast<double>(pixels[p].squares[value]));
            }
        const std::vector<float> replica_pool = pooled(replica), independent_pool = pooled(independent);
        for (std::size_t value = bounds[group]; value < bounds[group + 1]; ++value) {
            const std::size_t plane = value / band_count;
            const auto band = static_cast<int>(value % band_count);
            auto& variance = value < plane_values ? picture.variance[plane] : picture.difference_variance;
            for (std::size_t p = 0; p < pixels.size(); ++p) {
                const PixelSum& pixel = pixels[p];
                if (pixel.draws == 0) continue;
                const auto [a, b] = sums_of(pixel, value);
                const double mean = (a + b) / pixel.draws;
                if (value < plane_values) picture.light[plane][p][band] = static_cast<float>(mean);
                const float gain = independent_pool[p] > 0 ? replica_pool[p] / independent_pool[p] : 0;
                const float of_draws =
                    pixel.draws < 2
                        ? static_cast<float>(mean * mean)
                        : gain * independent_variance(pixel, a + b, static_cast<double>(pixel.squares[value]));
                const auto b_index = static_cast<std::size_t>(band);
                // The bins' errors of both worlds come from the same photons.
                const float of_bins = (group == 0   ? pixel.error[b_index]
                                       : group == 1 ? pixel.polarized_error[b_index]
                                       : group == 2 ? pixel.unpolarized_error[b_index]
                                                    : pixel.error[b_index] - pixel.unpolarized_error[b_index]) /
                                      static_cast<float>(pixel.draws);
                variance[p][band] = of_draws + of_bins * of_bins;
            }
        }
    }
    for (const PixelSum& pixel : pixels) picture.draws += pixel.draws;
    picture.draws /= static_cast<double>(pixels.size());
    return picture;
}

PictureError error_of(const std::vector<PixelSum>& pixels) {
    const auto radiance_of = [](const PixelSum& pixel) {
        double sum = 0;
        for (std::size_t band = 0; band < band_count; ++band) sum += static_cast<double>(pixel.mean(band));
        return sum / band_count;
    };
    double mean = 0, count = 0;
    for (const PixelSum& pixel : pixels) {
        if (pixel.draws == 0) continue;
        mean += radiance_of(pixel);
        ++count;
    }
    PictureError error;
    if (!(mean > 0)) return error;
    const double dark = dark_share * mean / count;
    for (const PixelSum& pixel : pixels) {
        if (pixel.draws == 0) continue;
        double a = 0, b = 0, of_bins = 0;
        for (std::size_t band = 0; band < band_count; ++band) {
            a += static_cast<double>(pixel.sums[0][band]) / band_count;
            b += static_cast<double>(pixel.sums[1][band]) / band_count;
            of_bins += static_cast<double>(pixel.error[band]) / band_count;
        }
        of_bins /= pixel.draws;
        const double radiance = radiance_of(pixel), scale = radiance * radiance + dark * dark;
        error.draws += static_cast<double>(replica_variance(pixel, a, b)) / scale / count;
        error.bins += of_bins * of_bins / scale / count;
    }
    return error;
}

std::vector<float> importance_of(const std::vector<PixelSum>& pixels, int width, int height) {
    std::vector<float> squared(pixels.size()), radiance(pixels.size());
    double mean = 0;
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        for (const std::size_t first : {std::size_t{0}, first_unpolarized}) {
            double a = 0, b = 0;
            for (std::size_t band = 0; band < band_count; ++band) {
                a += static_cast<double>(pixels[p].sums[0][first + band]);
                b += static_cast<double>(pixels[p].sums[1][first + band]);
            }
            squared[p] += replica_variance(pixels[p], a, b);
            if (pixels[p].draws > 0) radiance[p] += static_cast<float>((a + b) / pixels[p].draws);
        }
        mean += static_cast<double>(radiance[p]);
    }
    mean /= static_cast<double>(pixels.size());
    const BoxSums pooled(width, height);
    const std::vector<float> around_squared = pooled(squared), around = pooled(radiance);
    const std::vector<float> count = pooled(std::vector<float>(pixels.size(), 1.0f));
    const float dark = static_cast<float>(dark_share * mean);
    std::vector<float> importance(pixels.size());
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const float others = std::max(count[p] - 1, 1.0f);
        const float variance = std::max(around_squared[p] - squared[p], 0.0f) / others;
        const float level = std::max(around[p] - radiance[p], 0.0f) / others;
        const float scale = level * level + dark * dark;
        importance[p] = scale > 0 ? variance / scale : 0;
    }
    return importance;
}

std::vector<std::uint32_t> shared_out_draws(const std::vector<float>& importance, std::uint32_t least,
                                            double mean_draws) {
    std::vector<float> wish(importance.size());
    for (std::size_t p = 0; p < wish.size(); ++p) wish[p] = std::log2(std::pow(importance[p], error_power) + 1e-30f);
    const auto draws_of = [&](std::size_t p, float shift) {
        const float power = std::clamp(std::round(wish[p] + shift), 0.0f, std::log2(static_cast<float>(most_draws)));
        return std::max(static_cast<std::uint32_t>(1) << static_cast<unsigned>(power), least);
    };
    const auto mean_of = [&](float shift) {
        double sum = 0;
        for (std::size_t p = 0; p < wish.size(); ++p) sum += draws_of(p, shift);
        return sum / static_cast<double>(wish.size());
    };
    float low = -200, high = 200;  // the mean grows with the shift
    for (int step = 0; step < 40; ++step) {
        const float middle = 0.5f * (low + high);
        (mean_of(middle) <= mean_draws ? low : high) = middle;
    }
    std::vector<std::uint32_t> draws(wish.size());
    for (std::size_t p = 0; p < draws.size(); ++p) draws[p] = draws_of(p, low);
    return draws;
}

}  // namespace brewster
