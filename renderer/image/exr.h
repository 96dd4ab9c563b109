#pragma once
#include <string>

#include "image/image.h"

namespace brewster {

enum class ExrPrecision { half, single };

/// Writes all channels as scan lines, losslessly compressed, and the attributes as strings.
/// Half precision rounds to 11 significant bits. Variances, too small for halves, stay floats of 5 significant bits
/// (their own error is larger), and a channel with a value beyond 65504 stays as it is.
/// Throws Error when the file cannot be written.
void write_exr(const std::string& path, const Image& image, ExrPrecision precision = ExrPrecision::single);

/// Writes a Stokes picture with what its reader must know: R G B repeat S0, so that any viewer shows the radiance, and
/// the attributes `brewster.frame` and `brewster.s3` name the frame and the handedness of the components.
/// The picture must have S0.R, S0.G, S0.B.
void write_stokes_exr(const std::string& path, const Image& stokes, ExrPrecision precision = ExrPrecision::single);

/// Reads the half and float channels of a scan line or tiled file (the first part of several) and its string
/// attributes. Throws Error for what is no such file, is damaged, or holds subsampled channels.
Image read_exr(const std::string& path);

}  // namespace brewster
