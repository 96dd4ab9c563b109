// One draw's share of the sums over all draws; blending adds.

uniform sampler2D drawn_radiance;
uniform sampler2D drawn_variance;

layout(location = 0) out vec4 sum;
layout(location = 1) out vec4 sum_of_squares;
layout(location = 2) out vec4 sum_of_variances;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    sum = texelFetch(drawn_radiance, pixel, 0);
    sum_of_squares = sum * sum;
    sum_of_variances = texelFetch(drawn_variance, pixel, 0);
}
