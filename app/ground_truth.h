#pragma once
#include <string>
#include <vector>

#include "app/numbers.h"
#include "image/image.h"
#include "scene/rays.h"

namespace brewster {

/// Adds to a Stokes picture what a polarization camera would record, I0, I45, I90 and I135 per band (behind polarizers at
/// these angles from the picture's horizontal, counter-clockwise), and what none can: seen through the middle of each
/// pixel, the unit normal N.X N.Y N.Z, the depth Z along the camera's axis, the position P.X P.Y P.Z, both in the file's
/// coordinates and metres, and `material`, the number of the material as `info` lists them. Where nothing is seen these
/// are zero, and material is -1.
void add_ground_truth(Image& picture, const Scene& scene, const Rays& rays, const Camera& camera);

/// A picture's camera for cameras.json.
struct CameraRecord {
    std::string name, path;
    PictureSize size;
    Camera camera;
};

/// Pinhole matrices as computer vision writes them, row by row: `intrinsics` 3 x 3 in pixels, from the outer corner of
/// the first pixel; `world_to_camera` and `camera_to_world` 4 x 4, x to the right, y down, z forward, metres.
struct CameraMatrices {
    double intrinsics[3][3], world_to_camera[4][4], camera_to_world[4][4];
};

CameraMatrices camera_matrices(const Scene& scene, const Camera& camera, PictureSize size);

}  // namespace brewster
