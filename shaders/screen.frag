// The mean of the draws as the screen shows it.

#include "shared/tone.h"

uniform sampler2D sum;
uniform float draws;
uniform float exposure;    // EV
uniform vec2 screen_size;  // pixels

out vec4 colour;

void main() {
    vec3 radiance = texture(sum, gl_FragCoord.xy / screen_size).rgb / draws;
    colour = vec4(screen_colour(radiance, exposure), 1.0);
}
