// One draw's share of the sums over all draws; blending adds. The alpha of S0 counts them.

uniform sampler2D drawn_s0;
layout(location = 0) out vec4 sum;
#ifndef BREWSTER_CELLS
uniform sampler2D drawn_variance;
layout(location = 1) out vec4 sum_of_squares;
layout(location = 2) out vec4 sum_of_variances;
#endif
#ifdef BREWSTER_STOKES
uniform sampler2D drawn_s1, drawn_s2, drawn_s3, drawn_variance_linear, drawn_variance_s3;
layout(location = 3) out vec4 sum_s1;
layout(location = 4) out vec4 sum_s2;
layout(location = 5) out vec4 sum_s3;
layout(location = 6) out vec4 sum_of_variances_linear;
layout(location = 7) out vec4 sum_of_variances_s3;
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    sum = vec4(texelFetch(drawn_s0, pixel, 0).rgb, 1.0);
#ifndef BREWSTER_CELLS
    sum_of_squares = sum * sum;
    sum_of_variances = texelFetch(drawn_variance, pixel, 0);
#endif
#ifdef BREWSTER_STOKES
    sum_s1 = texelFetch(drawn_s1, pixel, 0);
    sum_s2 = texelFetch(drawn_s2, pixel, 0);
    sum_s3 = texelFetch(drawn_s3, pixel, 0);
    sum_of_variances_linear = texelFetch(drawn_variance_linear, pixel, 0);
    sum_of_variances_s3 = texelFetch(drawn_variance_s3, pixel, 0);
#endif
}
