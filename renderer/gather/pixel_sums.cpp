#include "gather/pixel_sums.h"

#include <algorithm>
#include <cmath>

namespace brewster {
namespace {

constexpr int pool_radius = 3;
constexpr double dark_share = 0.01;   // of the mean radiance, below which errors count against that
constexpr float error_power = 0.45f;  // of the squared error
constexpr std::uint32_t most_draws = 1u << 20;

/// Sums over (2 r + 1)^2 pixels around each, cut at the borders of the picture, or of tiles.
class BoxSums {
  public:
    BoxSums(int width, int height, int tile) : width_(width), height_(height), tile_(tile) {}
    BoxSums(int width, int height) : BoxSums(width, height, std::max(width, height)) {}

    std::vector<float> operator()(const std::vector<float>& values) const {
        std::vector<float> rows(values.size()), sums(values.size());
        for (int y = 0; y < height_; ++y)
            for (int x = 0; x < width_; ++x) {
                float sum = 0;
                for (int i = first(x); i <= last(x, width_); ++i) sum += values[at(i, y)];
                rows[at(x, y)] = sum;
            }
        for (int y = 0; y < height_; ++y)
            for (int i = first(y); i <= last(y, height_); ++i)
                for (int x = 0; x < width_; ++x) sums[at(x, y)] += rows[at(x, i)];
        return sums;
    }

  private:
    int first(int x) const { return std::max(x - pool_radius, x / tile_ * tile_); }
    int last(int x, int size) const { return std::min({x + pool_radius, (x / tile_ + 1) * tile_ - 1, size - 1}); }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }
    int width_, height_, tile_;
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

void add_draws(const LevelLight& seen, const BinsAlone& alone, int components, std::size_t first, std::size_t count,
               PixelSum& pixel) {
    for (std::size_t i = first; i < first + count && pixel.alone_draws < draws_of_bins_alone;
         ++i, ++pixel.alone_draws) {
        const LevelLight& light = alone.known[i] ? alone.light : seen;
        pixel.alone_known = pixel.alone_known || alone.known[i];
        for (std::size_t value = 0; value < 3 * static_cast<std::size_t>(components); ++value)
            pixel.alone[value] += light.stokes[value][i];
        for (std::size_t band = 0; band < band_count; ++band) {
            pixel.alone[first_unpolarized + band] +=
                components > 1 ? light.unpolarized[band][i] : light.stokes[band][i];
            pixel.alone_error[band] += light.error[band][i];
            pixel.alone_polarized_error[band] += light.polarized_error[band][i];
        }
    }
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

std::vector<BinsShare> shares_of_bins(const std::vector<PixelSum>& pixels, int width, int height) {
    std::vector<BinsShare> shares(pixels.size());
    const auto known = [](const PixelSum& pixel) { return pixel.alone_known && pixel.draws > 1; };
    if (std::none_of(pixels.begin(), pixels.end(), known)) return shares;
    std::vector<float> of_draws(pixels.size()), apart(pixels.size()), stated(pixels.size());
    std::vector<float> polarized(pixels.size()), counted(pixels.size());
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const PixelSum& pixel = pixels[p];
        if (!known(pixel)) continue;
        counted[p] = 1;
        for (std::size_t value = band_count; value < first_unpolarized; ++value) {
            const float difference = pixel.mean(value) - pixel.alone_mean(value);
            polarized[p] += difference * difference - replica_variance(pixel, static_cast<double>(pixel.sums[0][value]),
                                                                       static_cast<double>(pixel.sums[1][value]));
        }
        for (const std::size_t first : {std::size_t{0}, first_unpolarized}) {
            for (std::size_t band = 0; band < band_count; ++band) {
                const std::size_t value = first + band;
                const float difference = pixel.mean(value) - pixel.alone_mean(value);
                const float error = pixel.alone_error[band] / static_cast<float>(pixel.alone_draws);
                of_draws[p] += replica_variance(pixel, static_cast<double>(pixel.sums[0][value]),
                                                static_cast<double>(pixel.sums[1][value]));
                apart[p] += difference * difference;
                stated[p] += error * error;
            }
        }
    }
    const BoxSums pooled(width, height, tile_pixels);
    const std::vector<float> draws_pool = pooled(of_draws), apart_pool = pooled(apart), stated_pool = pooled(stated);
    const std::vector<float> polarized_pool = pooled(polarized), counted_pool = pooled(counted);
    constexpr auto polarized_values = static_cast<float>(first_unpolarized - band_count);
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        if (!known(pixels[p])) continue;
        const float draws = draws_pool[p] - of_draws[p];
        const float bins = std::max(stated_pool[p] - stated[p], apart_pool[p] - apart[p] - draws);
        if (!(draws > 0 && bins > 0)) continue;
        shares[p] = {draws / (draws + bins), bins / draws,
                     std::max(polarized_pool[p], 0.0f) / (polarized_values * counted_pool[p])};
    }
    return shares;
}

StokesPicture picture_of(const std::vector<PixelSum>& pixels, int width, int height) {
    StokesPicture picture(width, height);
    const BoxSums pooled(width, height);
    const std::vector<BinsShare> shares = shares_of_bins(pixels, width, height);
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
        for (std::size_t p = 0; p < pixels.size(); ++p)
            for (std::size_t value = bounds[group]; value < bounds[group + 1]; ++value) {
                const auto [a, b] = sums_of(pixels[p], value);
                replica[p] += replica_variance(pixels[p], a, b);
                independent[p] += independent_variance(pixels[p], a + b, static_cast<double>(pixels[p].squares[value]));
            }
        const std::vector<float> replica_pool = pooled(replica), independent_pool = pooled(independent);
        for (std::size_t p = 0; p < pixels.size(); ++p) {
            const PixelSum& pixel = pixels[p];
            if (pixel.draws == 0) continue;
            for (std::size_t value = bounds[group]; value < bounds[group + 1]; ++value) {
                const std::size_t plane = value / band_count;
                const auto band = static_cast<int>(value % band_count);
                auto& variance = value < plane_values ? picture.variance[plane] : picture.difference_variance;
                const auto [a, b] = sums_of(pixel, value);
                const double mean = (a + b) / pixel.draws;
                const auto [share, ratio, polarized] = shares[p];
                if (value < plane_values) {
                    auto& light = picture.light[plane][p][band];
                    light = static_cast<float>(mean);
                    if (share > 0) light += share * (pixel.alone_mean(value) - light);
                }
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
                float of_bins_alone = ratio * of_draws;
                if (group == 1 && share > 0) {  // cells may lie where draws hardly scatter
                    const float said = pixel.alone_polarized_error[b_index] / static_cast<float>(pixel.alone_draws);
                    of_bins_alone = std::max({of_bins_alone, polarized, said * said});
                }
                variance[p][band] =
                    (1 - share) * (1 - share) * (of_draws + of_bins * of_bins) + share * share * of_bins_alone;
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
