#pragma once
#include "image/image.h"
#include "image/png.h"

namespace brewster {

/// a - b of every channel that both pictures hold; variances V0.R .. V3.B are added instead. Throws Error for unequal
/// sizes or no common channel.
Image difference_image(const Image& a, const Image& b);

/// The relative difference of the band means of S0 (or R G B), (a - b) / sqrt(b^2 + e^2) with e = `epsilon` of b's
/// mean, as a picture: white where equal, orange where a is brighter, blue where it is darker; full colour at +-`full`.
ScreenImage difference_map(const Image& a, const Image& b, double epsilon, double full);

}  // namespace brewster
