#pragma once
#include "display/gl_object.h"

namespace brewster {

/// The linear light of a picture on the graphics side, whoever made it: means times the number of draws of each pixel,
/// which is the alpha of its S0 (of the cells': of theirs); 1 where a texture has none. In the layout of StokesPicture
/// (image/stokes_picture.h). Names of textures; 0 stands for black. They live as long as their maker.
struct LightTextures {
    struct World {
        GLuint s0 = 0, s1 = 0, s2 = 0, s3 = 0;
        GLuint variance_s0 = 0, variance_linear = 0, variance_s3 = 0;  ///< of S0; the larger of S1 and S2; S3
        GLuint squares_s0 = 0;  ///< sum over the draws of S0 squared; 0: the variance holds their spread already
    };
    World polarized, unpolarized;  ///< the latter has S0 alone
    GLuint cells = 0;              ///< colours of the bins' cells
};

}  // namespace brewster
