#pragma once
#include <string>
#include <vector>

#include "app/options.h"

namespace brewster {

/// One file that `shot` will write.
struct PictureName {
    std::string camera;
    Map map = Map::radiance;
    std::string path;
};

/// A path for each camera and map from a template with the placeholders {camera} and {map}. A slash inside a camera's
/// name becomes an underscore. Throws Error for another placeholder, an ending other than .png or .exr, or two pictures
/// that would get the same path.
std::vector<PictureName> name_pictures(const std::string& path_template, const std::vector<std::string>& cameras,
                                       const std::vector<Map>& maps);

/// Whether the path ends in .exr (else .png), in capitals or small letters.
bool is_exr(const std::string& path);

/// Makes the folders the pictures go to. Throws Error when one cannot be made or written to: before hours of work,
/// not after.
void prepare_folders(const std::vector<PictureName>& pictures);

}  // namespace brewster
