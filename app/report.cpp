#include "app/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/material_summary.h"
#include "app/scene_summary.h"
#include "scene/needs.h"

namespace brewster {
namespace {

using Json = nlohmann::ordered_json;

/// Names come from files and may hold bytes that are no UTF-8; those are replaced.
std::string text_of(const Json& report) {
    return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json list_of(glm::vec3 value) {
    return {value.x, value.y, value.z};
}
Json list_of(glm::dvec3 value) {
    return {value.x, value.y, value.z};
}

Json account(const Ledger::Account& quanta, std::size_t world, int band_count_in) {
    Json bands = Json::array();
    for (int band = 0; band < band_count_in; ++band)
        bands.push_back(decimal(quanta[world][static_cast<std::size_t>(band)]));
    return bands;
}

// Of the polarized world; of the unpolarized one under its own name where it differs.
Json ledger_object(const Ledger& ledger, const KernelChoice& kernel) {
    const auto world = [&](std::size_t w) -> Json {
        const auto of = [&](const Ledger::Account& quanta) { return account(quanta, w, kernel.bands); };
        return {{"emitted", of(ledger.emitted)},  {"absorbed", of(ledger.absorbed)}, {"escaped", of(ledger.escaped)},
                {"cut", of(ledger.cut)},          {"shading", of(ledger.shading)},   {"capped", of(ledger.capped)},
                {"roulette", of(ledger.roulette)}};
    };
    Json object = world(0);
    if (kernel.stokes > 1) object["unpolarized"] = world(1);
    object["balances"] = ledger.balances();
    return object;
}

Json solve_object(const SolveResult& result) {
    const Progress& progress = result.progress;
    const Ledger& ledger = result.ledger;
    return {
        {"scene", result.scene},
        {"seed", result.settings.seed},
        {"photons", progress.photons},
        {"seconds", progress.seconds},
        {"photons_per_second", progress.photons_per_second()},
        {"photons_by_thread", progress.photons_by_thread},
        {"bounces", progress.bounces},
        {"rays", progress.rays},
        {"bins2", progress.leaves},
        {"published_leaves", progress.published_leaves},
        {"bytes", progress.bytes},
        {"digest", result.digest},
        {"bins4", progress.gloss_leaves},
        {"transport",
         {{"stokes", result.kernel.stokes}, {"bands", result.kernel.bands}, {"gloss", result.kernel.gloss}}},
        {"ledger", ledger_object(ledger, result.kernel)},
        {"relative_error", progress.relative_error},
        {"first_snapshot_ms", progress.first_snapshot_ms},
        {"emission", {{"traced", progress.photons}, {"useful", progress.useful_photons}}},
        {"trouble", progress.trouble},
    };
}

Json lamp_object(const Lamp& lamp) {
    return {{"name", lamp.name},
            {"kind", lamp_kind_name(lamp.kind)},
            {"power", list_of(lamp.power)},
            {"power_unit", "lm"},
            {"intensity", list_of(lamp.intensity)},
            {"intensity_unit", lamp_intensity_unit(lamp.kind)},
            {"polarization", list_of(lamp.polarization)}};
}

// Angles in degrees, lengths in micrometres.
Json material_object(const Scene& scene, const Material& material) {
    const auto [yes, why] = polarizes(material);
    Json object = {{"name", material.name},
                   {"description", described(scene, material)},
                   {"polarizes", yes},
                   {"because", why},
                   {"base", base_name(material.base)},
                   {"albedo", list_of(material.albedo)},
                   {"interface", interface_name(material.interface.kind)},
                   {"emission", list_of(material.emission)},
                   {"double_sided", material.double_sided}};
    if (material.interface.present()) {
        object["n"] = list_of(material.interface.n);
        object["k"] = list_of(material.interface.k);
        object["finish"] = finish_name(material.interface.finish);
        object["m"] = material.interface.slope;
    }
    if (material.interface.finish == Finish::kirchhoff) {
        object["rms_height"] = material.interface.rms_height;
        object["correlation_length"] = material.interface.correlation_length;
    }
    if (material.base == Base::transparent) object["thin"] = material.thin;
    if (material.filter.kind != FilterKind::none) {
        object["filter"] = material.filter.kind == FilterKind::polarizer ? "polarizer" : "retarder";
        object["filter_angle"] = degrees(static_cast<double>(material.filter.angle));
        object["retardance"] = list_of(static_cast<float>(degrees(1.0)) * material.filter.retardance);
    }
    if (material.texture != no_texture) {
        const SurfaceTexture& texture = scene.textures[material.texture];
        object["texture"] = {
            {"width", texture.width}, {"height", texture.height}, {"mean", list_of(glm::dvec3(texture_mean(texture)))}};
    }
    if (material.alpha_cutoff > 0) object["alpha_cutoff"] = material.alpha_cutoff;
    return object;
}

Json camera_object(const Scene& scene, const Camera& camera) {
    return {{"name", camera.name},
            {"position", list_of(glm::dvec3(camera.position) + scene.centre)},
            {"forward", list_of(camera.forward)},
            {"up", list_of(camera.up)},
            {"vertical_field_of_view_degrees", degrees(static_cast<double>(camera.vertical_field_of_view))}};
}

Json chart_object(const Scene& scene, const Chart& chart) {
    return {{"mesh", chart.mesh},
            {"material", scene.materials[chart.material].name},
            {"area", chart.area},
            {"size", {chart.size_u, chart.size_v}},
            {"triangles", chart.triangle_count}};
}

Json band_object(const BandDifference& band) {
    Json object = {{"mean", band.mean_a},
                   {"reference_mean", band.mean_b},
                   {"rmse", band.rmse},
                   {"rmse_beyond_noise", band.rmse_beyond_noise},
                   {"relative_rmse", band.relative_rmse},
                   {"bias", band.bias},
                   {"bias_standard_error", nullptr}};
    if (band.bias_standard_error) object["bias_standard_error"] = *band.bias_standard_error;
    object["within_standard_errors"] = nullptr;
    if (band.within)
        object["within_standard_errors"] = {
            {"1", (*band.within)[0]}, {"2", (*band.within)[1]}, {"3", (*band.within)[2]}};
    Json percentiles = Json::object();
    for (std::size_t k = 0; k < difference_percentiles.size(); ++k)
        percentiles[std::to_string(difference_percentiles[k])] = band.percentiles[k];
    object["relative_percentiles"] = percentiles;
    return object;
}

Json polarization_object(const BandPolarization& band) {
    return {{"mean_dolp", band.mean_dolp_a},      {"reference_mean_dolp", band.mean_dolp_b},
            {"dolp_rmse", band.dolp_rmse},        {"dolp_bias", band.dolp_bias},
            {"aolp_pixels", band.aolp_pixels},    {"aolp_rmse_degrees", band.aolp_rmse},
            {"aolp_bias_degrees", band.aolp_bias}};
}

Json band_statistics_object(const BandStatistics& band) {
    Json object = {{"mean", band.mean}, {"standard_error", band.standard_error},
                   {"dop", band.dop},   {"dolp", band.dolp},
                   {"docp", band.docp}, {"aolp_degrees", nullptr}};
    if (band.aolp) object["aolp_degrees"] = *band.aolp;
    return object;
}

Json picture_list(const std::vector<PictureName>& pictures) {
    Json files = Json::array();
    for (const PictureName& picture : pictures)
        files.push_back({{"camera", picture.camera}, {"map", description(picture.map).name}, {"path", picture.path}});
    return files;
}

}  // namespace

SolveResult result_of(const Engine& engine) {
    return {engine.scene().name, engine.settings(), engine.progress(),
            engine.ledger(),     engine.digest(),   engine.kernel()};
}

std::string decimal(Wide number) {
    const bool negative = number < 0;
    std::string digits;
    do {
        const int digit = static_cast<int>(number % 10);
        digits += static_cast<char>('0' + (digit < 0 ? -digit : digit));
        number /= 10;
    } while (number != 0);
    if (negative) digits += '-';
    std::reverse(digits.begin(), digits.end());
    return digits;
}

std::string solve_report(const SolveResult& result) {
    return text_of(solve_object(result));
}

std::string shot_report(const SolveResult& result, const PicturesResult& made,
                        const std::vector<PictureName>& pictures) {
    Json report = {{"pictures", picture_list(pictures)}, {"exposure", made.exposure}, {"solve", solve_object(result)}};
    if (made.gather)
        report["gather"] = {
            {"draws", made.gather->draws},
            {"seconds", made.gather->seconds},
            {"coarse_share", made.gather->coarse_share},
            {"relative_error",
             {{"draws", std::sqrt(made.gather->error.draws)}, {"bins", std::sqrt(made.gather->error.bins)}}}};
    return text_of(report);
}

std::string info_report(const Scene& scene) {
    const Needs needs = needs_of(scene);
    Json materials = Json::array(), lamps = Json::array(), cameras = Json::array(), charts = Json::array();
    for (const Material& material : scene.materials) materials.push_back(material_object(scene, material));
    for (const Lamp& lamp : scene.lamps) lamps.push_back(lamp_object(lamp));
    for (const Camera& camera : scene.cameras) cameras.push_back(camera_object(scene, camera));
    for (const Chart& chart : scene.charts) charts.push_back(chart_object(scene, chart));
    return text_of({{"scene", scene.name},
                    {"low", list_of(scene.centre + glm::dvec3(scene.low))},
                    {"high", list_of(scene.centre + glm::dvec3(scene.high))},
                    {"triangles", scene.triangles.size()},
                    {"materials", materials},
                    {"lamps", lamps},
                    {"cameras", cameras},
                    {"charts", charts},
                    {"transport", {{"stokes", needs.stokes}, {"bands", needs.bands}, {"because", needs.reasons}}},
                    {"warnings", scene.warnings}});
}

std::string reference_report(const ReferenceResult& result) {
    Json mean = Json::array(), error = Json::array();
    for (const PictureMean& band : result.mean) {
        mean.push_back(band.mean);
        error.push_back(band.standard_error);
    }
    return text_of({{"scene", result.scene},
                    {"camera", result.camera},
                    {"polarization", result.polarized},
                    {"seed", result.seed},
                    {"samples", result.samples},
                    {"photons", result.photons},
                    {"seconds", result.seconds},
                    {"mean_radiance", mean},
                    {"mean_radiance_standard_error", error},
                    {"path", result.path}});
}

std::string compare_report(const PictureDifference& difference) {
    Json components = Json::object();
    for (int component = 0; component < 4; ++component) {
        const auto& bands = difference.components[static_cast<std::size_t>(component)];
        if (!bands) continue;
        Json object = Json::object();
        for (std::size_t band = 0; band < bands->size(); ++band) {
            object[std::string(1, band_letters[band])] = band_object((*bands)[band]);
        }
        components["S" + std::to_string(component)] = object;
    }
    Json report = {{"pixels", difference.pixels}, {"components", components}};
    if (difference.polarization) {
        Json object = Json::object();
        for (std::size_t band = 0; band < 3; ++band)
            object[std::string(1, band_letters[band])] = polarization_object((*difference.polarization)[band]);
        report["polarization"] = object;
    }
    return text_of(report);
}

std::string develop_report(const std::vector<PictureName>& pictures, const PictureStatistics& statistics) {
    Json bands = Json::object();
    for (std::size_t band = 0; band < statistics.bands.size(); ++band)
        bands[std::string(1, band_letters[band])] = band_statistics_object(statistics.bands[band]);
    return text_of({{"pictures", picture_list(pictures)}, {"pixels", statistics.pixels}, {"bands", bands}});
}

std::string camera_file(const Scene& scene, const std::vector<CameraRecord>& cameras) {
    Json list = Json::array();
    for (const CameraRecord& record : cameras) {
        const CameraMatrices matrices = camera_matrices(scene, record.camera, record.size);
        list.push_back({{"name", record.name},
                        {"picture", record.path},
                        {"width", record.size.width},
                        {"height", record.size.height},
                        {"intrinsics", matrices.intrinsics},
                        {"world_to_camera", matrices.world_to_camera},
                        {"camera_to_world", matrices.camera_to_world}});
    }
    Json materials = Json::array();
    for (const Material& material : scene.materials) materials.push_back(material.name);
    return text_of({{"scene", scene.name},
                    {"axes", "x right, y down, z forward; metres"},
                    {"materials", materials},
                    {"cameras", list}});
}

}  // namespace brewster
