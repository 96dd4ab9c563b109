#include "app/picture_names.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "base/error.h"

namespace brewster {
namespace {

std::string ending(const std::string& path) {
    std::string letters = std::filesystem::path(path).extension().string();
    std::transform(letters.begin(), letters.end(), letters.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return letters;
}

std::string filled(const std::string& path_template, const std::string& camera, Map map) {
    std::string camera_in_path = camera;
    std::replace(camera_in_path.begin(), camera_in_path.end(), '/', '_');
    std::string path;
    for (std::size_t at = 0; at < path_template.size();) {
        if (path_template[at] != '{') {
            path += path_template[at++];
            continue;
        }
        const std::size_t close = path_template.find('}', at);
        const std::string placeholder = path_template.substr(at, close == std::string::npos ? close : close + 1 - at);
        if (placeholder == "{camera}") {
            path += camera_in_path;
        } else if (placeholder == "{map}") {
            path += description(map).name;
        } else {
            throw Error("the name holds '" + placeholder + "', which stands for nothing", "--out " + path_template,
                        "use {camera} and {map}");
        }
        at += placeholder.size();
    }
    return path;
}

}  // namespace

bool is_exr(const std::string& path) {
    return ending(path) == ".exr";
}

std::vector<PictureName> name_pictures(const std::string& path_template, const std::vector<std::string>& cameras,
                                       const std::vector<Map>& maps) {
    if (const std::string letters = ending(path_template); letters != ".png" && letters != ".exr") {
        throw Error("the kind of picture is not clear", "--out " + path_template, "end the name in .png or .exr");
    }
    std::vector<PictureName> pictures;
    for (const std::string& camera : cameras) {
        for (const Map map : maps) {
            const std::string path = filled(path_template, camera, map);
            const auto same = [&](const PictureName& other) { return other.path == path; };
            if (std::any_of(pictures.begin(), pictures.end(), same)) {
                throw Error("several pictures would get the name " + path, "--out " + path_template,
                            "tell them apart by {camera} and {map}");
            }
            pictures.push_back({camera, map, path});
        }
    }
    return pictures;
}

void prepare_folders(const std::vector<PictureName>& pictures) {
    for (const PictureName& picture : pictures) {
        const std::filesystem::path folder = std::filesystem::path(picture.path).parent_path();
        const std::string name = folder.empty() ? "." : folder.string();
        std::error_code failure;
        std::filesystem::create_directories(name, failure);
        if (failure) {
            throw Error("the folder cannot be made (" + failure.message() + ")", name, "choose another with --out");
        }
        if (access(name.c_str(), W_OK | X_OK) != 0) {
            throw Error("the folder cannot be written to", name, "choose another with --out");
        }
        if (std::filesystem::is_directory(picture.path)) {
            throw Error("a folder of this name is in the way", picture.path, "choose another name with --out");
        }
    }
}

}  // namespace brewster
