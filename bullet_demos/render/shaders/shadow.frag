// Clear surfaces hold back a part of the light: as many points of the map as that is.
uniform float clear;
#include "noise.glsl"

void main() {
    if (clear > 0.0 && hash(vec3(gl_FragCoord.xy, 1.0)) < 0.66 * clear) discard;
}
